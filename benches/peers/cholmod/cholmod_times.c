/* Factors matrices written by `solver_peers factor` with CHOLMOD (METIS order, supernodal LLT) and prints the median processor
 * time of the factorisation and of solves with 1 and 8 right-hand sides as JSON lines.
 *
 *     cc -O2 cholmod_times.c -I/usr/include/suitesparse -lcholmod -lm -o cholmod_times
 *     OPENBLAS_NUM_THREADS=1 OMP_NUM_THREADS=1 ./cholmod_times FILE...
 *
 * Debian package: libsuitesparse-dev. */
#include <cholmod.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

static double processor_time(void) {
    struct timespec t;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

static int ascending(const void *a, const void *b) {
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

static void read_exactly(void *to, size_t size, size_t count, FILE *file, const char *path) {
    if (fread(to, size, count, file) != count) {
        fprintf(stderr, "%s: too short\n", path);
        exit(1);
    }
}

static void fill(double *x, int64_t n, int64_t columns) {
    for (int64_t i = 0; i < n * columns; i++) x[i] = (double)((i * 7919) % 101) - 50.0;
}

static void measure(const char *path) {
    FILE *file = fopen(path, "rb");
    if (!file) {
        perror(path);
        exit(1);
    }
    int64_t head[2];
    read_exactly(head, 8, 2, file, path);
    int64_t n = head[0], places = head[1];
    cholmod_common common;
    cholmod_l_start(&common);
    common.nmethods = 1;
    common.method[0].ordering = CHOLMOD_METIS;
    common.postorder = 1;
    common.supernodal = CHOLMOD_SUPERNODAL;
    cholmod_sparse *a = cholmod_l_allocate_sparse(n, n, places, 1, 1, -1, CHOLMOD_REAL, &common);
    read_exactly(a->p, 8, n + 1, file, path);
    read_exactly(a->i, 8, places, file, path);
    read_exactly(a->x, 8, places, file, path);
    fclose(file);
    double start = processor_time();
    cholmod_factor *factor = cholmod_l_analyze(a, &common);
    double analysis = processor_time() - start;
    int runs = n > 50000 ? 3 : 7;
    double factors[7], solves[2][7], sum = 0.0;
    for (int r = 0; r < runs; r++) {
        int repeats = 0;
        start = processor_time();
        do {
            cholmod_l_factorize(a, factor, &common);
            repeats++;
            factors[r] = (processor_time() - start) / repeats;
        } while (factors[r] * repeats < 0.25);
        if (common.status != CHOLMOD_OK) {
            fprintf(stderr, "%s: CHOLMOD status %d\n", path, common.status);
            exit(1);
        }
    }
    for (int k = 0; k < 2; k++) {
        cholmod_dense *b = cholmod_l_allocate_dense(n, k ? 8 : 1, n, CHOLMOD_REAL, &common);
        fill(b->x, n, k ? 8 : 1);
        cholmod_dense *x = NULL, *y = NULL, *e = NULL;
        for (int r = 0; r < runs; r++) {
            int repeats = 0;
            start = processor_time();
            do {
                cholmod_l_solve2(CHOLMOD_A, factor, b, NULL, &x, NULL, &y, &e, &common);
                repeats++;
                solves[k][r] = (processor_time() - start) / repeats;
            } while (solves[k][r] * repeats < 0.25);
        }
        if (k == 0)
            for (int64_t i = 0; i < n; i++) sum += ((double *)x->x)[i];
        cholmod_l_free_dense(&x, &common);
        cholmod_l_free_dense(&y, &common);
        cholmod_l_free_dense(&e, &common);
        cholmod_l_free_dense(&b, &common);
    }
    qsort(factors, runs, sizeof(double), ascending);
    qsort(solves[0], runs, sizeof(double), ascending);
    qsort(solves[1], runs, sizeof(double), ascending);
    const char *name = strrchr(path, '/');
    printf("{\"name\":\"%s\",\"n\":%lld,\"analysis\":%.4f,\"factor\":%.5f,\"solve\":%.6f,\"solve8\":%.6f,"
           "\"entries\":%.0f,\"gflop\":%.3f,\"sum\":%.12e}\n",
           name ? name + 1 : path, (long long)n, analysis, factors[runs / 2], solves[0][runs / 2],
           solves[1][runs / 2], (double)factor->xsize, 1e-9 * common.fl, sum);
    fflush(stdout);
    cholmod_l_free_factor(&factor, &common);
    cholmod_l_free_sparse(&a, &common);
    cholmod_l_finish(&common);
}

int main(int count, char **arguments) {
    for (int i = 1; i < count; i++) measure(arguments[i]);
    return 0;
}
