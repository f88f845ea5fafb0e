int adrx7(void* a) {
  (void)a;
  return 0;
}
