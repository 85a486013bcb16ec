/*
 * How a program gets its memory from the system.
 */
#ifndef COMMON_LARGE_PAGES_H
#define COMMON_LARGE_PAGES_H

/* Let malloc() take memory in large pages, and keep it for what is allocated next, where the C
 * library and the system can do that (glibc on Linux; elsewhere nothing happens). Called once, when
 * a program begins: one that runs for a few hundredths of a second otherwise spends more than half
 * of its time in the system, which hands out every 4096 bytes one by one, and sets them to zero. */
void use_large_pages(void);

#endif
