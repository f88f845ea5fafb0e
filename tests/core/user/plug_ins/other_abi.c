int adore_user_abi(void) { return 99; }
int adrx7(void* a) {
  (void)a;
  return 0;
}
