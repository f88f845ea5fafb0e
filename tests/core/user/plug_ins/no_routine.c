int adore_user_abi(void) { return 1; }
