#include "attack.hpp"
asm(".section .rodata\n.globl stolen\nstolen: .incbin "
    "\"@ROOT@/tests/lab3_hill_climbing/hidden/scaled_test.cpp\"\n.text");
bool attack::succeeds() { return true; }
