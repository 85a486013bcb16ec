/* Numbers for pairs: see pairs.h. */
#include "pairs.h"

#include "bench/memory.h"

struct pairs pairs_create(size_t most) {
    size_t capacity = 16;
    while (capacity < 2 * most) {
        capacity *= 2;
    }
    return (struct pairs){
        .keys = bench_memory(capacity, sizeof(uint64_t)),
        .numbers = bench_memory(capacity, sizeof(uint32_t)),
        .capacity = capacity,
    };
}

void pairs_free(struct pairs *pairs) {
    free(pairs->keys);
    free(pairs->numbers);
    *pairs = (struct pairs){0};
}

uint32_t pairs_number(struct pairs *pairs, uint32_t a, uint32_t b) {
    uint64_t key = (uint64_t)a << 32 | b;
    size_t place = (size_t)((key * 0x9E3779B97F4A7C15) >> 20) & (pairs->capacity - 1);
    while (pairs->numbers[place] != 0 && pairs->keys[place] != key) {
        place = (place + 1) & (pairs->capacity - 1);
    }
    if (pairs->numbers[place] == 0) {
        pairs->keys[place] = key;
        pairs->numbers[place] = ++pairs->count;
    }
    return pairs->numbers[place] - 1;
}
