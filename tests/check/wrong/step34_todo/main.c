/* What is to do in the main.c of the one in ../wrong.c: what is within marks does not count. */
int main(void) {
    int a = 0; // to do 34.1: nothing, since its picture is right
    /* BEGIN SOLUTION 34.2 marked */
    a++;
    /* STARTER
    // to do 34.2: the second
    END SOLUTION */
    a++; // task 34b.3 is done; to do 34b.300: no such task; to do 34b.30: the third
}
