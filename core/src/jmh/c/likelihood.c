/*
 * The yardstick of LikelihoodGrowthBenchmark: the log likelihood of rigid-marker (RigidMarkerLikelihood.java) in scalar C
 * without a lens's distortion, for as many references as are asked for. Numbers are made up; branches and memory are as
 * there.
 *
 *   gcc -O2 -fno-tree-vectorize -ffp-contract=off -o likelihood core/src/jmh/c/likelihood.c && ./likelihood 2 3 6 20 50 100
 *
 * Prints for each number of references the least time of a call, in ns, over samples of 64 calls.
 */
#include <stdio.h>
#include <stdlib.h>
#include <time.h>

enum { PACKED = 36, STATES = 64, SAMPLES = 20000 };

typedef struct {
    double rotation[9], offset[3], fx, fy, cx, cy;
} state_t;

static double whitened_squares(const double *m, const double *r)
{
    double sum = 0;
    for (int i = 0; i < 8; i++) {
        double s = 0;
        for (int j = 0; j <= i; j++) {
            s += *m++ * r[j];
        }
        sum += s * s;
    }
    return sum;
}

/* Written out, as in Java: the faster of both counts. */
static double whitened_squares_written(const double *m, const double *r)
{
    double s0 = m[0] * r[0];
    double s1 = m[1] * r[0] + m[2] * r[1];
    double s2 = m[3] * r[0] + m[4] * r[1] + m[5] * r[2];
    double s3 = m[6] * r[0] + m[7] * r[1] + m[8] * r[2] + m[9] * r[3];
    double s4 = m[10] * r[0] + m[11] * r[1] + m[12] * r[2] + m[13] * r[3] + m[14] * r[4];
    double s5 = m[15] * r[0] + m[16] * r[1] + m[17] * r[2] + m[18] * r[3] + m[19] * r[4] + m[20] * r[5];
    double s6 = m[21] * r[0] + m[22] * r[1] + m[23] * r[2] + m[24] * r[3] + m[25] * r[4] + m[26] * r[5] + m[27] * r[6];
    double s7 = m[28] * r[0] + m[29] * r[1] + m[30] * r[2] + m[31] * r[3] + m[32] * r[4] + m[33] * r[5] + m[34] * r[6]
            + m[35] * r[7];
    return s0 * s0 + s1 * s1 + s2 * s2 + s3 * s3 + s4 * s4 + s5 * s5 + s6 * s6 + s7 * s7;
}

static __attribute__((noinline)) double log_likelihood(const state_t *s, const double *points, const double *observed,
        const double *packed, int references, double log_determinant, int written)
{
    const double *r = s->rotation;
    double squares = 0;
    for (int m = 0; m < references; m++, points += 12, observed += 8, packed += PACKED) {
        double residuals[8];
        for (int k = 0; k < 4; k++) {
            double px = points[3 * k], py = points[3 * k + 1], pz = points[3 * k + 2];
            double x = r[0] * px + r[1] * py + r[2] * pz + s->offset[0];
            double y = r[3] * px + r[4] * py + r[5] * pz + s->offset[1];
            double z = r[6] * px + r[7] * py + r[8] * pz + s->offset[2];
            if (!(z > 0)) {
                return -1e300;
            }
            double inverse = 1 / z;
            residuals[2 * k] = s->fx * x * inverse + s->cx - observed[2 * k];
            residuals[2 * k + 1] = s->fy * y * inverse + s->cy - observed[2 * k + 1];
        }
        squares += written ? whitened_squares_written(packed, residuals) : whitened_squares(packed, residuals);
    }
    return log_determinant - 0.5 * squares;
}

static double uniform(void)
{
    return rand() / (RAND_MAX + 1.0);
}

static double *numbers(int count, double least, double most)
{
    double *out = malloc(count * sizeof *out);
    for (int i = 0; i < count; i++) {
        out[i] = least + (most - least) * uniform();
    }
    return out;
}

static double now(void)
{
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return 1e9 * t.tv_sec + t.tv_nsec;
}

int main(int count, char **values)
{
    volatile double sink = 0;
    for (int a = 1; a < count; a++) {
        int references = atoi(values[a]);
        double *points = numbers(12 * references, -250, 250);
        double *observed = numbers(8 * references, 0, 1000);
        double *packed = numbers(PACKED * references, -1, 1);
        state_t states[STATES];
        for (int i = 0; i < STATES; i++) {
            state_t s = {{1, 0.01 * uniform(), 0, 0, 1, 0.01 * uniform(), 0, 0.01 * uniform(), 1},
                {uniform(), uniform(), 900 + uniform()}, 1743, 1743, 1920, 1080};
            states[i] = s;
        }
        double least = 1e300;
        for (int written = 0; written < 2; written++) {
            for (int sample = 0; sample < SAMPLES; sample++) {
                double sum = 0, start = now();
                for (int i = 0; i < STATES; i++) {
                    sum += log_likelihood(&states[i], points, observed, packed, references, 0, written);
                }
                double time = (now() - start) / STATES;
                sink = sink + sum;
                least = time < least ? time : least;
            }
        }
        printf("%3d references %7.1f ns\n", references, least);
        free(points);
        free(observed);
        free(packed);
    }
    return 0;
}
