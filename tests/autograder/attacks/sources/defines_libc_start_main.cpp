extern "C" {
int __libc_start_main(void*, int, char**, void*, void*, void*);
int __libc_start_main(void*, int, char**, void*, void*, void*) { return 0; }
}
