/* SPDX-License-Identifier: BSD-3-Clause */
/* The C interface from pure C11. Truth: numbers.cpp, bit for bit.
 *
 *     interface_test numbers NUMBERS LAW        the numbers of the C++ library come out
 *     interface_test refusals                   bad input gives status and message
 *     interface_test threads                    two threads have their own messages, and share handles
 *     interface_test random SECONDS [SCENE]     random bytes as scenes and as laws; more on bytes of SCENE changed at random
 */
#include <fstiff.h>

#include <fenv.h>
#include <inttypes.h>
#include <math.h>
#include <pthread.h> /* not <threads.h>: ThreadSanitizer does not know its threads */
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

static int failures = 0;
#define CHECK(condition)                                                                                        \
    do {                                                                                                        \
        if (!(condition)) {                                                                                     \
            ++failures;                                                                                         \
            printf("%s:%d: failed: %s (message: %s)\n", __FILE__, __LINE__, #condition, fstiff_last_message()); \
        }                                                                                                       \
    } while (0)

#define ENDS(wanted, words, call)                            \
    do {                                                     \
        CHECK((call) == (wanted));                           \
        CHECK(strstr(fstiff_last_message(), words) != NULL); \
    } while (0)
#define OK(call) CHECK((call) == FSTIFF_OK)
#define REFUSES(words, call) ENDS(FSTIFF_REFUSED, words, call)
#define BAD(words, call) ENDS(FSTIFF_BAD_ARGUMENT, words, call)

static char* read_file(const char* name, size_t* length) {
    FILE* file = fopen(name, "rb");
    char* text = NULL;
    *length = 0;
    if (!file) {
        printf("cannot open %s\n", name);
        exit(1);
    }
    for (size_t room = 0;;) {
        if (*length + 1 >= room) text = realloc(text, room = 2 * room + 65536);
        if (!text) exit(1);
        const size_t got = fread(text + *length, 1, room - 1 - *length, file);
        *length += got;
        if (got == 0) break;
    }
    text[*length] = '\0';
    fclose(file);
    return text;
}

/* ---- Numbers ---- */

static const char* all_numbers;

/* The values of a line "key count values..." of the numbers; ends the test where there is none. */
static double* numbers_of(const char* key, size_t* count) {
    const size_t length = strlen(key);
    for (const char* line = all_numbers; *line; line = strchr(line, '\n') + 1) {
        if (strncmp(line, key, length) != 0 || line[length] != ' ') continue;
        char* at;
        *count = strtoul(line + length, &at, 10);
        double* values = malloc(*count * sizeof *values);
        if (!values) exit(1);
        for (size_t i = 0; i < *count; ++i) values[i] = strtod(at, &at);
        return values;
    }
    printf("no numbers of %s\n", key);
    exit(1);
}

static fstiff_face fine_face(void) {
    const fstiff_face fine = {.size = sizeof fine,
                              .rms_height = 0.832e-6,
                              .peak_radius = 40e-6,
                              .peak_density = 500e6,
                              .max_peak_height = 5.3e-6,
                              .r = 0.5,
                              .theta = 1.0,
                              .fractal_dimension = 1.62};
    return fine;
}
static fstiff_joint joint_of(const fstiff_face* face) {
    const fstiff_joint joint = {.size = sizeof joint, .face = face, .effective_modulus = 112.6e9};
    return joint;
}
static fstiff_contact* contact_of(const char* law) {
    const fstiff_face fine = fine_face();
    const fstiff_joint joint = joint_of(&fine);
    fstiff_contact* contact = NULL;
    OK(fstiff_contact_make(law, &joint, &contact));
    return contact;
}

enum { most = 512 };
typedef struct results {
    double of[7][most];
    int status[most];
} results;
static fstiff_points points_of(results* to) {
    fstiff_points points = {sizeof points, to->of[0], to->of[1], to->of[2], to->of[3],
                            to->of[4],     to->of[5], to->of[6], to->status};
    return points;
}

static void check_contact(const char* name, const fstiff_contact* contact) {
    static results found;
    const fstiff_points points = points_of(&found);
    size_t count;
    double* pressures = numbers_of("pressures", &count);
    for (int at_separations = 0; at_separations < 2; ++at_separations) {
        if (at_separations) memcpy(pressures, found.of[1], count * sizeof *pressures);
        CHECK((at_separations ? fstiff_contact_at_separations : fstiff_contact_at_pressures)(contact, pressures, count,
                                                                                             &points) == FSTIFF_OK);
        for (size_t i = 0; i < count; ++i) {
            char key[64];
            size_t seven;
            sprintf(key, "%s/%c%zu", name, at_separations ? 'd' : 'p', i);
            double* wanted = numbers_of(key, &seven);
            CHECK(seven == 7);
            for (size_t j = 0; j < seven; ++j) CHECK(found.of[j][i] == wanted[j]);
            CHECK(found.status[i] == FSTIFF_OK);
            free(wanted);
        }
    }
    free(pressures);
}

static void test_contacts(void) {
    for (const char** name = (const char*[]){"hertz", "fractal", NULL}; *name; ++name) {
        fstiff_contact* contact = contact_of(*name);
        check_contact(*name, contact);
        fstiff_contact_free(contact);
    }
    const fstiff_face fine = fine_face();
    fstiff_joint joint = joint_of(&fine);
    joint.interaction = FSTIFF_EFFECTIVE_SEPARATION, joint.interaction_length = 1e-4;
    fstiff_contact* contact;
    OK(fstiff_contact_make("hertz", &joint, &contact));
    check_contact("interacting", contact);
    fstiff_contact_free(contact);

    /* What is not asked for changes nothing, and results may be written where the arguments were, in more than one
     * part. */
    contact = contact_of("hertz");
    static double alone[most], in_place[most];
    static results all;
    for (size_t i = 0; i < most; ++i) in_place[i] = 1e5 * (1 + (double)i);
    const fstiff_points everything = points_of(&all);
    OK(fstiff_contact_at_pressures(contact, in_place, most, &everything));
    fstiff_points one = {sizeof one, NULL, NULL, alone, NULL, NULL, NULL, NULL, NULL};
    OK(fstiff_contact_at_pressures(contact, in_place, most, &one));
    CHECK(memcmp(alone, all.of[2], sizeof alone) == 0);
    one.stiffness = in_place;
    OK(fstiff_contact_at_pressures(contact, in_place, most, &one));
    CHECK(memcmp(alone, in_place, sizeof alone) == 0);
    fstiff_contact_free(contact);
}

/* K by every law is that of contact_of() of C++, of numbers or, where the law needs them, of the heights of a map. */
static void test_laws(void) {
    size_t count, sides_count, laws = 0, laws_of_maps = 0;
    double *pressures = numbers_of("pressures", &count), *heights = numbers_of("map", &count),
           *sides = numbers_of("map/sides", &sides_count);
    const fstiff_heights map = {sizeof map, heights, (size_t)sides[0], (size_t)sides[1], sides[2], sides[3]};
    const fstiff_solid steel = {205e9, 0.3, 0.7e9, 2e9};
    for (const char* law; strcmp(law = fstiff_law_name((int)laws), "unknown law") != 0; ++laws) {
        char key[64];
        sprintf(key, "law/%s", law);
        double *wanted = numbers_of(key, &count), stiffness[most];
        fstiff_face face = fine_face();
        face.rms_gradient = 0.1;
        if (count == 2) face = (fstiff_face){.size = sizeof face, .heights = &map};
        const fstiff_joint joint = {.size = sizeof joint, .face = &face, .upper = steel, .lower = steel};
        fstiff_contact* contact = NULL;
        const fstiff_points points = {.size = sizeof points, .stiffness = stiffness};
        OK(fstiff_contact_make(law, &joint, &contact));
        const int status = fstiff_contact_at_pressures(contact, pressures, count, &points);
        CHECK(status == FSTIFF_OK || wanted[count - 1] == 0);
        CHECK(memcmp(stiffness, wanted, count * sizeof *wanted) == 0 && wanted[0] > 0);
        if (strcmp(law, "summits") == 0) {
            fstiff_law* table = NULL;
            double K = 0;
            OK(fstiff_law_make(contact, pressures[0], pressures[1], FSTIFF_OUTSIDE_REFUSE, &table));
            OK(fstiff_law_at_pressure(table, pressures[1], NULL, &K, NULL));
            CHECK(fabs(K / wanted[1] - 1) < 1e-3);
            fstiff_law_free(table), ++laws_of_maps;
        }
        fstiff_contact_free(contact);
        free(wanted);
    }
    CHECK(laws > 10 && laws_of_maps == 1);
    free(pressures);
    free(heights);
    free(sides);
}

static void test_scene(const char* file) {
    size_t length;
    char* text = read_file(file, &length);
    /* law 0 fractal and 1 hertz with two distributions each, 2 greenwood_williamson */
    const size_t law[] = {0, 0, 1, 1, 2}, peaks[] = {0, 1, 0, 1, 0};
    for (size_t curve = 0; curve < 5; ++curve) {
        char key[64];
        size_t count;
        sprintf(key, "scene/p%zu", curve);
        double* pressures = numbers_of(key, &count);
        sprintf(key, "scene/k%zu", curve);
        double* wanted = numbers_of(key, &count);
        fstiff_contact* contact;
        OK(fstiff_contact_of_scene(text, length, NULL, law[curve], peaks[curve], &contact));
        fstiff_points points = {sizeof points, NULL, NULL, pressures, NULL, NULL, NULL, NULL, NULL};
        OK(fstiff_contact_at_pressures(contact, pressures, count, &points));
        CHECK(memcmp(pressures, wanted, count * sizeof *wanted) == 0);
        fstiff_contact_free(contact);
        free(pressures);
        free(wanted);
    }
    fstiff_contact* contact;
    CHECK(fstiff_contact_of_scene(text, length, "s.toml", 3, 0, &contact) == FSTIFF_BAD_ARGUMENT && !contact);
    CHECK(fstiff_contact_of_scene(text, length, "s.toml", 2, 1, &contact) == FSTIFF_BAD_ARGUMENT && !contact);
    free(text);
}

/* ---- Friction ---- */

static void check_friction(const fstiff_law* law) {
    size_t count;
    double* w = numbers_of("friction", &count);
    double ratio = 0, a = 0, b = 0;
    CHECK(fstiff_tangential_ratio(205e9, 0.3, 70e9, 0.33, &ratio) == FSTIFF_OK && ratio == w[0]);
    fstiff_friction* friction = NULL;
    OK(fstiff_friction_make(law, 0.3, ratio, &friction));
    CHECK(fstiff_friction_first_slip(friction, w[1], 1e-7, &a, &b) == FSTIFF_OK && a == w[2] && b == w[3]);
    CHECK(fstiff_friction_cycle(friction, w[1], 1e-7, &a, &b) == FSTIFF_OK && a == w[4] && b == w[5]);
    OK(fstiff_friction_cycle(friction, w[1], 1e-7, NULL, NULL));
    CHECK(fstiff_law_energy(law, w[1], &a) == FSTIFF_OK && a == w[6]);
    CHECK(fstiff_law_touch(law, &a) == FSTIFF_OK && a == w[7]);

    fstiff_slip state = {.size = sizeof state, .separation = w[1]};
    free(w);
    feclearexcept(FE_ALL_EXCEPT);
    for (int i = 0; i < 40; ++i) {
        char key[64];
        sprintf(key, "friction/%d", i);
        w = numbers_of(key, &count);
        fstiff_slip other = {.size = sizeof other};
        double p, q[2], tangent[9], stored;
        OK(fstiff_friction_step(friction, &state, w[0], w + 1, &other, NULL, NULL, NULL));
        OK(fstiff_friction_step(friction, &state, w[0], w + 1, &state, &p, q, tangent));
        CHECK(memcmp(&state, &other, sizeof state) == 0);
        CHECK(p == w[3] && q[0] == w[4] && q[1] == w[5]);
        for (int j = 0; j < 9; ++j) CHECK(tangent[j] == w[6 + j]);
        CHECK(fstiff_friction_stored_energy(friction, &state, &stored) == FSTIFF_OK && stored == w[15]);
        CHECK(state.separation == w[0] && state.count == (int)w[16] && count == 17 + 3 * (size_t)state.count);
        for (int j = 0; j < state.count; ++j)
            CHECK(state.levels[j] == w[17 + 3 * j] && state.drags[j][0] == w[18 + 3 * j] &&
                  state.drags[j][1] == w[19 + 3 * j]);
        free(w);
    }

    CHECK(!fetestexcept(FE_INVALID | FE_DIVBYZERO)); /* hosts may trap them */
    fstiff_friction_free(friction);
}

/* Whatever a host has kept: a status, and numbers or nothing. */
static void test_random_slips(const fstiff_friction* friction, double closest) {
    const double sizes[] = {0, 1e-12, 1e-7, 1e-6, 1, 1e200, 1e308};
    for (int n = 0; n < 20000; ++n) {
        fstiff_slip before = {.size = sizeof before, .separation = closest + 1e-9 * (n % 300), .count = n % 17};
        for (int i = 0; i < before.count; ++i) {
            const double length = sizes[n % 7] * ((1 + i) / 16.0), angle = 2.1 * i + n;
            before.levels[i] = before.separation + (1 + i) * (n % 3 ? 1e-7 : 1e300);
            before.drags[i][0] = length * cos(angle), before.drags[i][1] = length * sin(angle);
        }
        fstiff_slip after = {.size = sizeof after, .separation = -7};
        const double slip[2] = {sizes[(n / 7) % 7], -sizes[(n / 49) % 7]};
        double numbers[12], *const p = numbers, *const q = numbers + 1, *const tangent = numbers + 3;
        for (int i = 0; i < 12; ++i) numbers[i] = -7;
        const int status = fstiff_friction_step(friction, &before, closest + sizes[n % 6], slip, &after, p, q, tangent);
        CHECK(status == FSTIFF_OK || status == FSTIFF_OUT_OF_NUMBERS);
        for (int i = 0; i < 12; ++i) CHECK(status == FSTIFF_OK ? isfinite(numbers[i]) : numbers[i] == -7);
        if (status != FSTIFF_OK)
            CHECK(after.separation == -7 && after.count == 0);
        else /* what a step remembers is what a step takes */
            CHECK(fstiff_friction_step(friction, &after, closest, (const double[]){0, 0}, NULL, NULL, NULL, NULL) !=
                  FSTIFF_REFUSED);
        if (failures > 5) break;
    }
}

static void test_refusals_of_friction(void) {
    fstiff_contact* hertz = contact_of("hertz");
    fstiff_law *law, *plastic;
    OK(fstiff_law_make(hertz, 1e5, 1e8, FSTIFF_OUTSIDE_REFUSE, &law));
    fstiff_contact_free(hertz);
    fstiff_friction *friction = NULL, *none = (fstiff_friction*)&friction;
    BAD("law", fstiff_friction_make(NULL, 0.3, 0.8, &none));
    CHECK(none == NULL);
    BAD("made", fstiff_friction_make(law, 0.3, 0.8, NULL));
    REFUSES("friction = -0.1", fstiff_friction_make(law, -0.1, 0.8, &none));
    REFUSES("ratio = nan", fstiff_friction_make(law, 0.3, (double)NAN, &none));
    fstiff_contact* flowing = contact_of("fractal");
    OK(fstiff_law_make(flowing, 1e5, 1e8, FSTIFF_OUTSIDE_REFUSE, &plastic));
    fstiff_contact_free(flowing);
    REFUSES("must be elastic", fstiff_friction_make(plastic, 0.3, 0.8, &none));
    fstiff_law_free(plastic);
    REFUSES("poisson_ratio", fstiff_tangential_ratio(1, 0.6, 1, 0.3, &(double){0}));
    BAD("ratio", fstiff_tangential_ratio(1, 0.3, 1, 0.3, NULL));
    OK(fstiff_friction_make(law, 0.3, 0.8, &friction));

    double d, a = -7, b = -7;
    OK(fstiff_law_at_pressure(law, 1e7, &d, NULL, NULL));
    REFUSES("the range of the law", fstiff_law_energy(law, 1, &a));
    BAD("energy", fstiff_law_energy(law, d, NULL));
    BAD("separation", fstiff_law_touch(law, NULL));
    BAD("law", fstiff_law_touch(NULL, &a));
    BAD("friction", fstiff_friction_first_slip(NULL, d, 1e-7, &a, &b));
    REFUSES("slip = -1", fstiff_friction_first_slip(friction, d, -1, &a, &b));
    REFUSES("separation", fstiff_friction_first_slip(friction, (double)NAN, 1e-7, &a, &b));
    REFUSES("amplitude", fstiff_friction_cycle(friction, d, (double)NAN, &a, &b));
    CHECK(a == -7 && b == -7);
    CHECK(fstiff_friction_first_slip(friction, d, 1e-7, NULL, &b) == FSTIFF_OK && b > 0);

    const fstiff_slip good = {
        .size = sizeof good, .separation = d, .levels = {d + 1e-7, d + 2e-7}, .drags = {{1e-9, 0}}, .count = 2};
    fstiff_slip bad = good, after = {.size = sizeof after};
    const double slip[2] = {1e-8, 0}, no_number[2] = {0, (double)NAN};
    a = -7;
#define STEP(before, to, by) fstiff_friction_step(friction, before, to, by, &after, &a, NULL, NULL)
    BAD("before", STEP(NULL, d, slip));
    BAD("slip", STEP(&good, d, NULL));
    REFUSES("separation = inf", STEP(&good, (double)INFINITY, slip));
    REFUSES("slip = nan", STEP(&good, d, no_number));
    bad.size = 8;
    BAD("before->size = 8", STEP(&bad, d, slip));
    const int counts[] = {-1, 17, 2147483647};
    for (size_t i = 0; i < 3; ++i) {
        bad = good, bad.count = counts[i];
        REFUSES("count of a slip", STEP(&bad, d, slip));
    }
    bad = good, bad.levels[1] = bad.levels[0];
    REFUSES("further than the one before it", STEP(&bad, d, slip));
    bad = good, bad.levels[0] = d;
    REFUSES("further than the one before it", STEP(&bad, d, slip));
    bad = good, bad.levels[1] = (double)INFINITY;
    REFUSES("level of a slip = inf: must be finite", STEP(&bad, d, slip));
    bad = good, bad.drags[1][1] = (double)NAN;
    REFUSES("drag of a slip", STEP(&bad, d, slip));
    REFUSES("drag of a slip", fstiff_friction_stored_energy(friction, &bad, &a));
    bad = good, bad.separation = (double)NAN;
    REFUSES("separation of a slip", STEP(&bad, d, slip));
    CHECK(a == -7 && after.separation == 0);
    after.size = 0;
    BAD("after->size = 0", STEP(&good, d, slip));
    CHECK(a == -7);
    test_random_slips(friction, d);
    fstiff_friction_free(friction);
    fstiff_friction_free(NULL);
    fstiff_law_free(law);
}

/* ---- Laws ---- */

static void check_law(const fstiff_law* law) {
    double p[7], d[7], k[7], in_place[7], stiffness[7];
    int status[7];
    for (size_t i = 0; i < 7; ++i) {
        char key[64];
        size_t seven;
        sprintf(key, "law/%zu", i);
        double *w = numbers_of(key, &seven), a = 0, b = 0, c = 0;
        OK(fstiff_law_at_pressure(law, w[0], &a, &b, &c));
        CHECK(a == w[1] && b == w[2] && c == w[3]);
        OK(fstiff_law_at_separation(law, w[1], &a, &b, &c));
        CHECK(a == w[4] && b == w[5] && c == w[6]);
        CHECK(fstiff_law_at_separation(law, w[1], NULL, &b, NULL) == FSTIFF_OK && b == w[5]);
        p[i] = w[4], d[i] = in_place[i] = w[1], k[i] = w[5];
        free(w);
    }
    OK(fstiff_law_at_separations(law, in_place, 7, in_place, stiffness, status));
    for (size_t i = 0; i < 7; ++i) {
        CHECK(fabs(in_place[i] / p[i] - 1) < 200 * 2.3e-16); /* the bound of tabulated/contact_law.hpp */
        CHECK(fabs(stiffness[i] / k[i] - 1) < 200 * 2.3e-16);
        CHECK(status[i] == FSTIFF_OK);
    }
    OK(fstiff_law_at_pressures(law, p, 7, in_place, stiffness, NULL));
    for (size_t i = 0; i < 7; ++i) CHECK(fabs(in_place[i] - d[i]) < 1e-9 * 0.832e-6);
}

/* Of a law whose K is not -dp/dd: 300 points, so that two parts and a rest are computed, and one that is refused. */
static void test_tangents(void) {
    fstiff_contact* contact = contact_of("fractal");
    fstiff_law* law;
    OK(fstiff_law_make(contact, 1e5, 1e8, FSTIFF_OUTSIDE_REFUSE, &law));
    fstiff_contact_free(contact);
    fstiff_law_facts facts = {.size = sizeof facts};
    CHECK(fstiff_law_facts_of(law, &facts) == FSTIFF_OK && facts.stiffness_is_slope == 0);
    double d[300], p[300], slope[300];
    int status[300];
    for (int i = 0; i < 300; ++i) d[i] = facts.min_separation + (facts.max_separation - facts.min_separation) * i / 299;
    d[299] = 1;
    CHECK(fstiff_law_tangents_at_separations(law, d, 300, p, slope, status) == FSTIFF_REFUSED);
    CHECK(status[299] == FSTIFF_REFUSED && strstr(fstiff_last_message(), "separation"));
    for (int i = 0; i < 299; ++i) {
        double a = 0, K = 0, b = 0;
        CHECK(fstiff_law_at_separation(law, d[i], &a, &K, &b) == FSTIFF_OK && status[i] == FSTIFF_OK);
        CHECK(fabs(p[i] / a - 1) < 200 * 2.3e-16 && fabs(slope[i] / b - 1) < 200 * 2.3e-16);
        CHECK(fabs(slope[i] / K - 1) > 0.1);
    }
    CHECK(p[299] == 0 && slope[299] == 0);
    CHECK(fstiff_law_tangents_at_separations(NULL, d, 1, p, slope, NULL) == FSTIFF_BAD_ARGUMENT);
    fstiff_law_free(law);
}

static void test_law(const char* file) {
    size_t length, written = 0;
    char* text = read_file(file, &length);
    fstiff_contact* contact = contact_of("hertz");
    fstiff_law *made, *read;
    OK(fstiff_law_make(contact, 1e5, 1e8, FSTIFF_OUTSIDE_EXTRAPOLATE, &made));
    fstiff_contact_free(contact);
    check_law(made);
    CHECK(fstiff_law_text(made, NULL, 0, &written) == FSTIFF_OK && written == length);
    char* buffer = malloc(length + 1);
    if (!buffer) exit(1);
    CHECK(fstiff_law_text(made, buffer, length, &written) == FSTIFF_BAD_ARGUMENT && written == length);
    OK(fstiff_law_text(made, buffer, length + 1, &written));
    CHECK(memcmp(buffer, text, length + 1) == 0);
    OK(fstiff_law_of_text(text, length, &read));
    check_law(read);
    check_friction(made);
    check_friction(read);
    fstiff_law_facts facts = {.size = sizeof facts};
    OK(fstiff_law_facts_of(read, &facts));
    CHECK(facts.min_pressure == 1e5 && facts.max_pressure == 1e8 && facts.stiffness_is_slope == 1);
    CHECK(facts.outside == FSTIFF_OUTSIDE_EXTRAPOLATE && facts.relative_error > 0 && facts.relative_error < 1e-9);
    /* an open contact bears nothing, and NaN is refused point by point */
    const double some[] = {10, facts.max_separation, (double)NAN};
    double p[3], k[3];
    int status[3];
    CHECK(fstiff_law_at_separations(read, some, 3, p, k, status) == FSTIFF_REFUSED);
    CHECK(p[0] == 0 && k[0] == 0 && fabs(p[1] / 1e5 - 1) < 1e-9 && p[2] == 0 && k[2] == 0);
    CHECK(status[0] == FSTIFF_OK && status[1] == FSTIFF_OK && status[2] == FSTIFF_REFUSED);
    fstiff_law_free(made);
    fstiff_law_free(read);
    free(buffer);
    free(text);
}

static void check_measured(const char* key, const fstiff_surface* found, int with_shape) {
    size_t count;
    double* wanted = numbers_of(key, &count);
    const fstiff_measured all[] = {
        found->rms_height,        found->peak_radius, found->peak_density,   found->fractal_dimension,
        found->fractal_roughness, found->r,           found->theta,          found->rms_gradient,
        found->skewness,          found->kurtosis,    found->max_peak_height};
    const size_t known = with_shape ? 11 : 7;
    CHECK(count == 2 * known + (with_shape ? 3 : 0));
    for (size_t i = 0; i < known; ++i) {
        CHECK(all[i].value == wanted[2 * i] && all[i].error == wanted[2 * i + 1]);
        CHECK(all[i].known == (wanted[2 * i] != 0));
    }
    if (with_shape) {
        CHECK(found->lambda_s == wanted[22] && found->lambda_c == wanted[23]);
        CHECK((double)found->peaks == wanted[24]);
    }
    free(wanted);
}

static void test_measurement(void) {
    fstiff_measure_options options = {
        .size = sizeof options, .lambda_s = FSTIFF_NO_CUT_OFF, .lambda_c = FSTIFF_NO_CUT_OFF};
    fstiff_surface surface = {.size = sizeof surface};
    size_t count;
    double* heights = numbers_of("profile", &count);
    OK(fstiff_measure_profile(heights, count, 1e-6, &options, &surface));
    check_measured("profile/measured", &surface, 0);
    CHECK(surface.lambda_s == 0 && surface.lambda_c == 0 && surface.peaks > 100 && surface.rms_gradient.known);
    /* by the table of the standards: five steps; the short waves are gone */
    const double rough = surface.rms_gradient.value;
    OK(fstiff_measure_profile(heights, count, 1e-6, NULL, &surface));
    check_measured("profile/default", &surface, 1);
    CHECK(surface.lambda_s >= 5e-6 * 0.999 && surface.rms_gradient.value < rough);
    options.lambda_s = 20e-6;
    CHECK(fstiff_measure_profile(heights, count, 1e-6, &options, &surface) == FSTIFF_OK && surface.lambda_s == 20e-6);
    options.lambda_s = FSTIFF_NO_CUT_OFF;
    free(heights);

    size_t four;
    heights = numbers_of("map", &count);
    double* sides = numbers_of("map/sides", &four);
    const size_t rows = (size_t)sides[0], columns = (size_t)sides[1];
    OK(fstiff_measure_map(heights, rows, columns, sides[2], sides[3], &options, &surface));
    check_measured("map/measured", &surface, 0);
    OK(fstiff_measure_map(heights, rows, columns, sides[2], sides[3], NULL, &surface));
    check_measured("map/default", &surface, 1);
    heights[3 * columns + 4] = (double)NAN;
    OK(fstiff_measure_map(heights, rows, columns, sides[2], sides[3], NULL, &surface));
    check_measured("map/missing", &surface, 1);
    options.detrend = "ellipsoid";
    CHECK(fstiff_measure_map(heights, rows, columns, sides[2], sides[3], &options, &surface) == FSTIFF_REFUSED);
    CHECK(strstr(fstiff_last_message(), "ellipsoid"));
    free(heights);
    free(sides);
}

/* ---- The answer of a joint ---- */

/* K, its band and its law of numbers, of two faces and of heights are those of a scene to the last digit. */
static void test_answer(void) {
    const char* scene =
        "surface = { Ra = \"0.8 um\", Sdq = 0.1, process = \"ground\" }\n"
        "[material.upper]\nname = \"steel\"\nhardness = \"2 GPa\"\n"
        "[material.lower]\nname = \"steel\"\nhardness = \"3 GPa\"\n"
        "[contact]\npressures = [\"1 MPa\", \"100 MPa\"]\nnominal_area = \"1 cm^2\"\n";
    const double pressures[2] = {1e6, 100e6};
    fstiff_face face = {.size = sizeof face, .process = FSTIFF_PROCESS_GROUND};
    face.mean_height = 0.8e-6, face.rms_gradient = 0.1;
    fstiff_joint joint = {.size = sizeof joint, .face = &face, .nominal_area = 1e-4};
    joint.upper = (fstiff_solid){210e9, 0.3, 0, 2e9};
    joint.lower = (fstiff_solid){210e9, 0.3, 0, 3e9};
    double K[2], low[2], high[2], loading[2], causes[2 * FSTIFF_CAUSES], wanted[2];
    int law[2], status[2], doubtful = 7;
    const fstiff_answer_points to = {.size = sizeof to,
                                     .stiffness = K,
                                     .stiffness_p05 = low,
                                     .stiffness_p95 = high,
                                     .loading_stiffness = loading,
                                     .causes = causes,
                                     .law = law,
                                     .status = status};
    CHECK(fstiff_answer(&joint, pressures, 2, &to, &doubtful) == FSTIFF_OK && doubtful == 0);
    const double prior[2] = {causes[FSTIFF_CAUSE_PRIOR], causes[FSTIFF_CAUSES + FSTIFF_CAUSE_PRIOR]};
    const double* const found[] = {K, low, high, loading, prior};
    const char* const paths[] = {"stiffness_Pa_per_m", "stiffness_p05_Pa_per_m", "stiffness_p95_Pa_per_m",
                                 "loading_stiffness_Pa_per_m", "causes.prior"};
    fstiff_document* made = NULL;
    OK(fstiff_run(scene, strlen(scene), "scene", NULL, &made));
    for (int i = 0; i < 5; ++i) {
        char path[64];
        size_t count;
        snprintf(path, sizeof path, "answer.*.%s", paths[i]);
        CHECK(fstiff_document_numbers(made, path, wanted, 2, &count) == FSTIFF_OK && count == 2);
        CHECK(memcmp(found[i], wanted, sizeof wanted) == 0);
    }
    fstiff_document_free(made);
    CHECK(strcmp(fstiff_cause_name(FSTIFF_CAUSE_MEASUREMENT), "measurement") == 0);
    CHECK(strcmp(fstiff_cause_name(FSTIFF_CAUSE_LONG_WAVES), "long_waves") == 0);
    CHECK(strcmp(fstiff_cause_name(FSTIFF_CAUSE_FORM), "form") == 0 && FSTIFF_CAUSE_FORM + 1 == FSTIFF_CAUSES);
    CHECK(strcmp(fstiff_cause_name(-1), "unknown cause") == 0 &&
          strcmp(fstiff_cause_name(FSTIFF_CAUSES), "unknown cause") == 0);
    CHECK(strcmp(fstiff_last_message(), "") == 0);
    const char* keys[] = {"stiffness_p05_N_per_m", "separation_m", "thermal_conductance_W_per_m2K"};
    double low_of_area[2], separation[2], heat[2] = {1, 1};
    double* numbers[] = {low_of_area, separation, heat};
    fstiff_answer_points by_key = {.size = sizeof by_key, .key_count = 3, .keys = keys, .numbers = numbers};
    OK(fstiff_answer(&joint, pressures, 2, &by_key, NULL));
    CHECK(low_of_area[0] == low[0] * 1e-4 && separation[0] > separation[1] && heat[0] == 0);
    keys[1] = "separation";
    REFUSES("keys = \"separation\": must be one of force_N, ", fstiff_answer(&joint, pressures, 2, &by_key, NULL));
    keys[1] = NULL;
    BAD("keys", fstiff_answer(&joint, pressures, 2, &by_key, NULL));
    face.mean_height = 0.8; /* micrometres */
    CHECK(fstiff_answer(&joint, pressures, 2, &to, &doubtful) == FSTIFF_OK && doubtful == 1);
    CHECK(strstr(fstiff_last_message(), "m is above 1 mm: a unit is likely wrong") != NULL);
    face.mean_height = 0.8e-6;
    joint.lower = (fstiff_solid){0};
    CHECK(fstiff_answer(&joint, pressures, 2, &to, &doubtful) == FSTIFF_REFUSED);
    CHECK(strstr(fstiff_last_message(), "lower.youngs_modulus = 0: must be") != NULL);
    joint.lower = (fstiff_solid){210e9, 0.3, 0, 3e9};
    OK(fstiff_answer(&joint, pressures, 2, &to, &doubtful));
    CHECK(strcmp(fstiff_law_name(law[0]), "plastic") == 0 && status[1] == FSTIFF_OK);
    CHECK(strcmp(fstiff_law_name(-1), "unknown law") == 0 && strcmp(fstiff_law_name(999), "unknown law") == 0);

    enum { n = 2048 };
    static double heights[n];
    unsigned state = 1;
    double at = 0;
    for (int i = 0; i < n; ++i) {
        state = state * 1664525u + 1013904223u;
        at = 0.98 * at + ((double)(state >> 8) / 0x1p24 - 0.5) * 1e-7;
        heights[i] = at;
    }
    const fstiff_heights array = {.size = sizeof array, .heights = heights, .columns = n, .dx = 0.5e-6};
    fstiff_face measured = {.size = sizeof measured, .heights = &array};
    fstiff_face fine = {.size = sizeof fine, .rms_height = 0.1e-6, .rms_gradient = 0.05};
    joint.face = &measured, joint.other = &fine, joint.samples = -1;
    CHECK(fstiff_answer(&joint, pressures, 2, &to, NULL) == FSTIFF_OK && K[0] > 0);
    const double without = K[0];
    joint.samples = 50;
    CHECK(fstiff_answer(&joint, pressures, 2, &to, NULL) == FSTIFF_OK && K[0] == without && low[0] < K[0]);

    BAD("joint", fstiff_answer(NULL, pressures, 2, &to, NULL));
    BAD("pressures", fstiff_answer(&joint, NULL, 2, &to, NULL));
    BAD("pressures: must have at least one", fstiff_answer(&joint, pressures, 0, &to, NULL));
    REFUSES("pressure = -1", fstiff_answer(&joint, (const double[]){1e6, -1}, 2, &to, NULL));
    joint.face = NULL;
    BAD("face", fstiff_answer(&joint, pressures, 2, &to, NULL));
    joint.face = &face, face.rms_height = 1e-6;
    REFUSES("mean_height: must not be given with rms_height", fstiff_answer(&joint, pressures, 2, &to, NULL));
    face.rms_height = 0, face.process = 99;
    BAD("process = 99", fstiff_answer(&joint, pressures, 2, &to, NULL));
    face.process = 0, face.mean_height = NAN;
    REFUSES("mean_height = nan", fstiff_answer(&joint, pressures, 2, &to, NULL));
    face.mean_height = 0.8e-6, joint.other = NULL, joint.upper.hardness = 50e6;
    CHECK(fstiff_answer(&joint, pressures, 2, &to, &doubtful) == FSTIFF_OUT_OF_REACH && doubtful == 1);
    CHECK(strstr(fstiff_last_message(), "is above the hardness") != NULL);
    CHECK(status[0] == FSTIFF_OK && status[1] == FSTIFF_OUT_OF_REACH && K[0] > 0 && K[1] == 0 && law[1] == -1);
}

/* The law of an answer: that of C++ bit for bit, and its slope at the pressures is the K of their points. */
static void test_law_of_answer(void) {
    const double quantiles[3] = {0.05, 0.5, 0.95};
    enum { n = 21 };
    size_t count, of_laws;
    double *pressures = numbers_of("answer/pressures", &count), *laws = numbers_of("answer/laws", &of_laws);
    CHECK(count == n && of_laws == 9 * n);
    const fstiff_face face = {.size = sizeof face, .rms_height = 1e-6, .rms_gradient = 0.1};
    fstiff_joint joint = {.size = sizeof joint, .face = &face};
    joint.upper = joint.lower = (fstiff_solid){210e9, 0.3, 0, 2e9};
    double ends[3][n];
    const fstiff_answer_points to = {
        .size = sizeof to, .stiffness_p05 = ends[0], .stiffness = ends[1], .stiffness_p95 = ends[2]};
    OK(fstiff_answer(&joint, pressures, n, &to, NULL));
    fstiff_law* law;
    for (int q = 0; q < 3; ++q) {
        OK(fstiff_answer_law(&joint, pressures, n, quantiles[q], 0, 0, FSTIFF_OUTSIDE_EXTRAPOLATE, &law));
        fstiff_law_facts facts = {.size = sizeof facts};
        CHECK(fstiff_law_facts_of(law, &facts) == FSTIFF_OK && facts.stiffness_is_slope == 1);
        CHECK(facts.min_pressure == pressures[0] && facts.max_pressure == pressures[n - 1]);
        for (int i = 0; i < n; ++i) {
            const double* of_cpp = laws + 3 * (q * n + i);
            double d, K, p, slope;
            OK(fstiff_law_at_pressure(law, pressures[i], &d, &K, NULL));
            OK(fstiff_law_at_separation(law, d, &p, NULL, &slope));
            CHECK(d == of_cpp[0] && K == of_cpp[1] && slope == of_cpp[2]);
            CHECK(fabs(slope / ends[q][i] - 1) < 1e-3);
        }
        fstiff_law_free(law);
    }
    OK(fstiff_answer_law(&joint, pressures, n, 0.5, 2e6, 5e7, FSTIFF_OUTSIDE_CLAMP, &law));
    double at_end = 0, K = 0;
    OK(fstiff_law_at_pressure(law, 5e7, NULL, &at_end, NULL));
    CHECK(fstiff_law_at_pressure(law, 9e9, NULL, &K, NULL) == FSTIFF_OK && K == at_end);
    fstiff_law_free(law);
    free(pressures);
    free(laws);
}

/* The laws of the first loading and after one: those of C++ bit for bit. */
static void test_laws_after_a_load(void) {
    const double greatest[2] = {0, 2e7};
    enum { n = 21 };
    size_t count, of_laws;
    double *pressures = numbers_of("answer/pressures", &count), *laws = numbers_of("answer/laws_after", &of_laws);
    CHECK(count == n && of_laws == 6 * n);
    const fstiff_face face = {.size = sizeof face, .rms_height = 1e-6, .rms_gradient = 0.1};
    fstiff_joint joint = {.size = sizeof joint, .face = &face};
    joint.upper = joint.lower = (fstiff_solid){210e9, 0.3, 0, 2e9};
    fstiff_law *made[2], *law = NULL;
    for (int k = 0; k < 2; ++k) {
        OK(fstiff_answer_law_after(&joint, pressures, n, 0.5, greatest[k], 0, 0, FSTIFF_OUTSIDE_EXTRAPOLATE, &made[k]));
        fstiff_law_facts facts = {.size = sizeof facts};
        CHECK(fstiff_law_facts_of(made[k], &facts) == FSTIFF_OK && facts.stiffness_is_slope == k);
        for (int i = 0; i < n; ++i) {
            const double* of_cpp = laws + 3 * (k * n + i);
            double d, K, slope;
            OK(fstiff_law_at_pressure(made[k], pressures[i], &d, &K, NULL));
            OK(fstiff_law_at_separation(made[k], d, NULL, NULL, &slope));
            CHECK(d == of_cpp[0] && K == of_cpp[1] && slope == of_cpp[2]);
        }
    }
    double K = 0, same = 0; /* H/(E g) of the joint */
    OK(fstiff_law_after(made[0], 2e7, 2e9 / (210e9 / 1.82 * 0.1), &law));
    OK(fstiff_law_at_pressure(law, 5e6, NULL, &K, NULL));
    OK(fstiff_law_at_pressure(made[1], 5e6, NULL, &same, NULL));
    CHECK(fabs(K / same - 1) < 1e-6);
    fstiff_law_free(law);
    REFUSES("greatest_pressure", fstiff_law_after(made[0], 2e9, 0.1, &law));
    REFUSES("H/(E g)", fstiff_law_after(made[0], 2e7, -1, &law));
    BAD("first_loading", fstiff_law_after(NULL, 2e7, 0.1, &law));
    REFUSES("greatest_pressure",
            fstiff_answer_law_after(&joint, pressures, n, 0.5, (double)NAN, 0, 0, FSTIFF_OUTSIDE_CLAMP, &law));
    BAD("joint", fstiff_answer_law_after(NULL, pressures, n, 0.5, 2e7, 0, 0, FSTIFF_OUTSIDE_CLAMP, &law));
    for (int k = 0; k < 2; ++k) fstiff_law_free(made[k]);
    free(pressures);
    free(laws);
}

/* A motion of many contacts: the steps of each, and derivatives that are differences. */
static void test_motion(void) {
    enum { contacts = 3, steps = 16, count = contacts * steps };
    fstiff_contact* hertz = contact_of("hertz");
    fstiff_law* law;
    fstiff_friction* friction = NULL;
    OK(fstiff_law_make(hertz, 1e5, 1e8, FSTIFF_OUTSIDE_EXTRAPOLATE, &law));
    OK(fstiff_friction_make(law, 0.3, 0.8, &friction));
    double d, separations[count], slips[2 * count], by[3 * steps] = {0}, p[count], q[2 * count], tangents[9 * count];
    double responses_by[3 * count];
    OK(fstiff_law_at_pressure(law, 1e7, &d, NULL, NULL));
    for (int c = 0; c < contacts; ++c)
        for (int i = 0; i < steps; ++i) {
            const int at = c * steps + i;
            separations[at] = d - 1e-8 * (1 + c) * sin(0.7 * i);
            slips[2 * at] = 2e-8 * cos(0.5 * i), slips[2 * at + 1] = 1e-8 * sin(0.3 * i + c);
            by[3 * i + 1] = cos(0.5 * i); /* the amplitude of the first slip */
        }
    const fstiff_friction* const one = friction;
    fstiff_motion motion = {.size = sizeof motion,
                            .contacts = contacts,
                            .steps = steps,
                            .separations = separations,
                            .slips = slips,
                            .directions = 1,
                            .motion_by = by,
                            .pressures = p,
                            .tractions = q,
                            .tangents = tangents,
                            .responses_by = responses_by};
    OK(fstiff_friction_motion(&one, 1, &motion));
    fstiff_slip states[contacts];
    for (int c = 0; c < contacts; ++c) {
        states[c] = (fstiff_slip){.size = sizeof *states, .separation = separations[c * steps]};
        fstiff_slip moved = states[c];
        for (int i = 0; i < steps; ++i) {
            const int at = c * steps + i;
            double pressure, traction[2], tangent[9];
            OK(fstiff_friction_step(friction, &moved, separations[at], slips + 2 * at, &moved, &pressure, traction,
                                    tangent));
            CHECK(p[at] == pressure && q[2 * at] == traction[0] && q[2 * at + 1] == traction[1]);
            CHECK(memcmp(tangents + 9 * at, tangent, sizeof tangent) == 0);
        }
    }
    motion.states = states, motion.directions = 0, motion.motion_by = NULL;
    OK(fstiff_friction_motion(&one, 1, &motion));
    CHECK(states[0].separation == separations[steps - 1] && states[0].count > 0);
    motion.states = NULL;
    double up[2 * count], down[2 * count];
    for (int side = 0; side < 2; ++side) {
        for (int i = 0; i < count; ++i) slips[2 * i] *= side == 0 ? 1 + 1e-6 : (1 - 1e-6) / (1 + 1e-6);
        motion.tractions = side == 0 ? up : down;
        OK(fstiff_friction_motion(&one, 1, &motion));
    }
    for (int at = 0; at < count; ++at) {
        const double difference = (up[2 * at] - down[2 * at]) / (2 * 2e-8 * 1e-6);
        CHECK(fabs(responses_by[3 * at + 1] / difference - 1) < 1e-5);
    }
    REFUSES("laws", fstiff_friction_motion((const fstiff_friction* const[]){one, one}, 2, &motion));
    separations[3] = (double)NAN;
    REFUSES("separation = nan", fstiff_friction_motion(&one, 1, &motion));
    BAD("motion", fstiff_friction_motion(&one, 1, NULL));
    BAD("frictions", fstiff_friction_motion(NULL, 1, &motion));
    motion.slips = NULL;
    BAD("slips", fstiff_friction_motion(&one, 1, &motion));
    fstiff_friction_free(friction);
    fstiff_law_free(law);
    fstiff_contact_free(hertz);
}

static void test_refusals_of_law_of_answer(void) {
    const double pressures[3] = {1e6, 3e6, 1e7};
    const fstiff_face face = {.size = sizeof face, .rms_height = 1e-6, .rms_gradient = 0.1};
    fstiff_joint joint = {.size = sizeof joint, .face = &face, .samples = -1};
    joint.upper = joint.lower = (fstiff_solid){210e9, 0.3, 0, 2e9};
    fstiff_law* law = NULL;
    REFUSES("quantile = 0.1: must be 0.05, 0.5 or 0.95", fstiff_answer_law(&joint, pressures, 3, 0.1, 0, 0, 0, &law));
    REFUSES("max_pressure = ", fstiff_answer_law(&joint, pressures, 3, 0.5, 0, 1e8, 0, &law));
    REFUSES("min_pressure = nan", fstiff_answer_law(&joint, pressures, 3, 0.5, NAN, 0, 0, &law));
    REFUSES("points with a stiffness = 1", fstiff_answer_law(&joint, pressures, 1, 0.5, 0, 0, 0, &law));
    REFUSES("outside", fstiff_answer_law(&joint, pressures, 3, 0.5, 0, 0, FSTIFF_OUTSIDE_EXACT, &law));
    BAD("outside = 4", fstiff_answer_law(&joint, pressures, 3, 0.5, 0, 0, 4, &law));
    BAD("joint", fstiff_answer_law(NULL, pressures, 3, 0.5, 0, 0, 0, &law));
    BAD("pressures", fstiff_answer_law(&joint, NULL, 3, 0.5, 0, 0, 0, &law));
    BAD("made", fstiff_answer_law(&joint, pressures, 3, 0.5, 0, 0, 0, NULL));
    CHECK(law == NULL);
}

/* ---- Refusals ---- */

/* NaN of either sign is no number, whatever a law does beyond its range. */
static void test_nan_in_laws(const fstiff_contact* hertz) {
    const double nan = (double)NAN, nans[] = {nan, -nan};
    for (int outside = FSTIFF_OUTSIDE_REFUSE; outside <= FSTIFF_OUTSIDE_EXTRAPOLATE; ++outside) {
        fstiff_law* law = NULL;
        double p = -7, k = -7;
        int status[2];
        const char* why = outside == FSTIFF_OUTSIDE_EXACT ? " = nan: must be " : " = nan: must be a number";
        OK(fstiff_law_make(hertz, 1e5, 1e6, outside, &law));
        for (int i = 0; i < 2; ++i) {
            REFUSES(why, fstiff_law_at_separation(law, nans[i], &p, &k, NULL));
            CHECK(strncmp(fstiff_last_message(), "separation = nan", 16) == 0);
            REFUSES(why, fstiff_law_at_pressure(law, nans[i], &p, &k, NULL));
            CHECK(strncmp(fstiff_last_message(), "pressure = nan", 14) == 0);
            REFUSES("separation = nan: must be a number", fstiff_law_energy(law, nans[i], &p));
        }
        double many[2];
        REFUSES(why, fstiff_law_at_separations(law, nans, 2, many, NULL, status));
        REFUSES(why, fstiff_law_tangents_at_separations(law, nans, 2, many, NULL, status));
        REFUSES(why, fstiff_law_at_pressures(law, nans, 2, many, NULL, status));
        CHECK(p == -7 && k == -7 && status[0] == FSTIFF_REFUSED && status[1] == FSTIFF_REFUSED);
        fstiff_law_free(law);
    }
}

/* A length without an address is a lost pointer, not the built-in scene. */
static void test_lost_pointers(void) {
    fstiff_document* document = (fstiff_document*)&document;
    const size_t lengths[] = {1, 3, 1000, SIZE_MAX};
    for (size_t i = 0; i < 4; ++i) {
        const size_t n = lengths[i];
        BAD("scene: must not be NULL", fstiff_run(NULL, n, "x", NULL, &document));
        CHECK(document == NULL);
        BAD("scene: must not be NULL", fstiff_export(NULL, n, NULL, "to = law", &document));
        BAD("scene: must not be NULL", fstiff_identify(NULL, n, NULL, NULL, "fit = sigma", &document));
        fstiff_contact* contact;
        fstiff_law* law;
        BAD("text: must not be NULL", fstiff_contact_of_scene(NULL, n, NULL, 0, 0, &contact));
        BAD("text: must not be NULL", fstiff_law_of_text(NULL, n, &law));
    }
    OK(fstiff_export(NULL, 0, NULL, "to = law", &document)); /* the built-in scene */
    double some;
    size_t count;
    char word[4];
    BAD("buffer: must not be NULL", fstiff_document_text(document, NULL, 9, &count));
    fstiff_document_free(document);
    OK(fstiff_run(NULL, 0, NULL, NULL, &document));
    BAD("values: must not be NULL", fstiff_document_numbers(document, "answer.*.pressure_Pa", NULL, 9, &count));
    BAD("path: must not be NULL", fstiff_document_numbers(document, NULL, &some, 1, &count));
    BAD("buffer: must not be NULL", fstiff_document_word(document, "answer.0.law", NULL, sizeof word, &count));
    fstiff_document_free(document);
    const double one[] = {1e6};
    const fstiff_measured_curve lost[] = {{sizeof lost[0], NULL, one, NULL, 1, 0},
                                          {sizeof lost[0], one, NULL, NULL, 1, 0}};
    for (int i = 0; i < 2; ++i)
        BAD(i ? "values: must not be NULL" : "pressures: must not be NULL",
            fstiff_identify(NULL, 0, NULL, &lost[i], "fit = sigma", &document));
    const fstiff_heights no_heights = {sizeof no_heights, NULL, 4, 4, 1e-6, 1e-6};
    BAD("heights: must not be NULL", fstiff_spectrum(&no_heights, NULL, &document));
}

static void test_refusals(void) {
    test_lost_pointers();
    fstiff_face fine = fine_face();
    fstiff_joint joint = joint_of(&fine);
    fstiff_contact* none = (fstiff_contact*)&fine;
    BAD("law: must not be NULL", fstiff_contact_make(NULL, &joint, &none));
    CHECK(none == NULL);
    BAD("made: must not be NULL", fstiff_contact_make("hertz", &joint, NULL));
    BAD("joint", fstiff_contact_make("hertz", NULL, &none));
    joint.face = NULL;
    BAD("face", fstiff_contact_make("hertz", &joint, &none));
    joint = joint_of(&fine);
    fine.size = 8;
    BAD("face->size = 8", fstiff_contact_make("hertz", &joint, &none));
    fine.size = SIZE_MAX;
    BAD("face->size", fstiff_contact_make("hertz", &joint, &none));
    fine = fine_face();
    REFUSES("must be one of", fstiff_contact_make("herz", &joint, &none));
    REFUSES("must be one of", fstiff_contact_make("", &joint, &none));
    REFUSES("needs a measured map", fstiff_contact_make("summits", &joint, &none));
    REFUSES("needs", fstiff_contact_make("plastic", &joint, &none));
    double* const fields[] = {
        &fine.rms_height,     &fine.peak_radius,       &fine.peak_density, &fine.r,
        &fine.theta,          &fine.fractal_dimension, &fine.rms_gradient, &joint.effective_modulus,
        &joint.upper.hardness};
    const double bad[] = {(double)NAN, -1, (double)INFINITY, -(double)INFINITY};
    for (size_t i = 0; i < sizeof fields / sizeof *fields; ++i)
        for (size_t j = 0; j < 4; ++j) {
            const double good = *fields[i];
            if (fields[i] == &joint.upper.hardness && j == 2) continue;  // a body that never yields
            *fields[i] = bad[j];
            REFUSES("must be", fstiff_contact_make("fractal", &joint, &none));
            CHECK(none == NULL);
            *fields[i] = good;
        }
    joint.interaction = 7;
    BAD("interaction = 7", fstiff_contact_make("hertz", &joint, &none));
    joint.interaction = FSTIFF_EFFECTIVE_SEPARATION;
    REFUSES("interaction length", fstiff_contact_make("hertz", &joint, &none));

    BAD("text", fstiff_contact_of_scene(NULL, 0, NULL, 0, 0, &none));
    REFUSES("scene", fstiff_contact_of_scene("", 0, NULL, 0, 0, &none));
    REFUSES("s.toml", fstiff_contact_of_scene("a = [", 5, "s.toml", 0, 0, &none));

    static results found;
    fstiff_points points = points_of(&found);
    fstiff_contact* hertz = contact_of("hertz");
    const double some[] = {1e6, (double)NAN, -1, 0, 1e-320, 1e300, 2e6};
    BAD("contact", fstiff_contact_at_pressures(NULL, some, 7, &points));
    BAD("pressures", fstiff_contact_at_pressures(hertz, NULL, 7, &points));
    BAD("at least one", fstiff_contact_at_pressures(hertz, some, 0, &points));
    BAD("must fit into memory", fstiff_contact_at_pressures(hertz, some, SIZE_MAX / 2, &points));
    BAD("points", fstiff_contact_at_pressures(hertz, some, 7, NULL));
    REFUSES("pressure = nan", fstiff_contact_at_pressures(hertz, some, 7, &points));
    const int wanted[] = {FSTIFF_OK,           FSTIFF_REFUSED,      FSTIFF_REFUSED, FSTIFF_REFUSED,
                          FSTIFF_OUT_OF_REACH, FSTIFF_OUT_OF_REACH, FSTIFF_OK};
    for (size_t i = 0; i < 7; ++i) {
        CHECK(found.status[i] == wanted[i]);
        for (size_t j = 0; j < 7; ++j) CHECK(wanted[i] == FSTIFF_OK ? found.of[j][i] > 0 : found.of[j][i] == 0);
    }
    points.size = 0;
    BAD("points->size = 0", fstiff_contact_at_separations(hertz, some, 7, &points));

    fstiff_contact* persson;
    fine.rms_gradient = 0.1, joint = joint_of(&fine);
    OK(fstiff_contact_make("persson", &joint, &persson));
    points = points_of(&found);
    REFUSES("law persson: gives no contact_density", fstiff_contact_at_pressures(persson, some, 1, &points));
    points.contact_density = NULL;
    CHECK(fstiff_contact_at_pressures(persson, some, 1, &points) == FSTIFF_OK && found.of[2][0] > 0);
    fstiff_contact_free(persson);

    fstiff_contact* hybrid;
    double stiffness[2];
    for (int skewed = 0; skewed < 2; ++skewed) {
        fine.skewness = skewed ? -1 : 0, fine.kurtosis = skewed ? 4.5 : 3;
        OK(fstiff_contact_make("hybrid", &joint, &hybrid));
        OK(fstiff_contact_at_pressures(hybrid, some, 1, &points));
        stiffness[skewed] = found.of[2][0];
        fstiff_contact_free(hybrid);
    }
    CHECK(stiffness[1] > 1.5 * stiffness[0]);
    fine.kurtosis = 0;
    REFUSES("skewness: needs kurtosis", fstiff_contact_make("hybrid", &joint, &hybrid));
    fine.kurtosis = 1.5;
    REFUSES("kurtosis = 1.5", fstiff_contact_make("hybrid", &joint, &hybrid));
    fine.skewness = fine.kurtosis = 0;

    fstiff_law *law = NULL, *no_law;
    REFUSES("max_pressure", fstiff_law_make(hertz, 1e6, 1e5, FSTIFF_OUTSIDE_REFUSE, &no_law));
    REFUSES("min_pressure", fstiff_law_make(hertz, -1, 1e5, FSTIFF_OUTSIDE_REFUSE, &no_law));
    BAD("outside = 9", fstiff_law_make(hertz, 1e5, 1e6, 9, &no_law));
    BAD("contact", fstiff_law_make(NULL, 1e5, 1e6, 0, &no_law));
    REFUSES("contact law text", fstiff_law_of_text("fstiff", 6, &no_law));
    BAD("text", fstiff_law_of_text(NULL, 6, &no_law));
    OK(fstiff_law_make(hertz, 1e5, 1e6, FSTIFF_OUTSIDE_REFUSE, &law));
    double p = -7, k = -7;
    REFUSES("the range of the law", fstiff_law_at_separation(law, 1, &p, &k, NULL));
    REFUSES("the range of the law", fstiff_law_at_pressure(law, 2e9, &p, &k, NULL));
    test_nan_in_laws(hertz);
    CHECK(p == -7 && k == -7);
    BAD("law", fstiff_law_at_separation(NULL, 1, &p, &k, NULL));
    size_t length;
    BAD("length", fstiff_law_text(law, NULL, 0, NULL));
    BAD("buffer", fstiff_law_text(law, NULL, 10, &length));
    fstiff_law_free(law);
    OK(fstiff_law_make(hertz, 1e5, 1e6, FSTIFF_OUTSIDE_EXACT, &law));
    REFUSES("outside", fstiff_law_text(law, NULL, 0, &length));
    fstiff_law_free(law);
    fstiff_contact_free(hertz);

    double heights[400];
    fstiff_surface surface = {.size = sizeof surface};
    fstiff_measure_options options = {.size = sizeof options};
    for (int i = 0; i < 400; ++i) heights[i] = 1e-6 * (i % 7) - 2e-7 * (i % 11);
    BAD("heights", fstiff_measure_profile(NULL, 400, 1e-6, NULL, &surface));
    BAD("at least one", fstiff_measure_profile(heights, 0, 1e-6, NULL, &surface));
    REFUSES("spacing", fstiff_measure_profile(heights, 400, (double)NAN, NULL, &surface));
    BAD("must fit into memory", fstiff_measure_map(heights, SIZE_MAX, 2, 1, 1, NULL, &surface));
    REFUSES("dx", fstiff_measure_map(heights, 20, 20, -1, 1, NULL, &surface));
    options.resamples = -3;
    REFUSES("resamples", fstiff_measure_profile(heights, 400, 1e-6, &options, &surface));
    options.resamples = 0, options.lambda_s = (double)NAN;
    REFUSES("lambda_s", fstiff_measure_profile(heights, 400, 1e-6, &options, &surface));
    options.lambda_s = 0, options.shortest_lag = 1e-6;
    REFUSES("longest_lag", fstiff_measure_profile(heights, 400, 1e-6, &options, &surface));
    surface.size = 1;
    BAD("surface->size = 1", fstiff_measure_profile(heights, 400, 1e-6, NULL, &surface));
    heights[3] = (double)INFINITY, surface.size = sizeof surface;
    REFUSES("height", fstiff_measure_profile(heights, 400, 1e-6, NULL, &surface));

    fstiff_document_free(NULL);
    fstiff_contact_free(NULL);
    fstiff_law_free(NULL);
    for (int status = -1; status < 12; ++status) CHECK(strlen(fstiff_strerror(status)) > 4);
    CHECK(strcmp(fstiff_strerror(99), "unknown status") == 0);
    CHECK(strcmp(fstiff_version(), FSTIFF_VERSION_WANTED) == 0);
}

/* ---- Threads ---- */

typedef struct task {
    const fstiff_contact* contact;
    const fstiff_law* law;
    const char* bad_law;
    double sum;
    int failures;
} task;

static const char small_scene[] =
    "[surface]\nrms_height = '0.8 um'\npeak_radius = '40 um'\npeak_density = '500 /mm^2'\n"
    "[material.upper]\nyoungs_modulus = '205 GPa'\npoisson_ratio = 0.3\n"
    "[contact]\npressures = ['1 MPa']\nlaws = ['hertz']\npeaks = [{ theta = 1.0, r = 0.5 }]\n";

static void* work(void* argument) {
    task* const of = argument;
    const fstiff_face fine = fine_face();
    const fstiff_joint joint = joint_of(&fine);
    of->failures += strcmp(fstiff_last_message(), "") != 0; /* a new thread has no message */
    for (int i = 0; i < 200; ++i) {
        fstiff_contact* none;
        of->failures += fstiff_contact_make(of->bad_law, &joint, &none) != FSTIFF_REFUSED;
        const double p = 1e5 * (1 + i);
        double k, kt;
        fstiff_points points = {.size = sizeof points, .stiffness = &k};
        of->failures += fstiff_contact_at_pressures(of->contact, &p, 1, &points) != FSTIFF_OK;
        of->failures += fstiff_law_at_pressure(of->law, p, NULL, &kt, NULL) != FSTIFF_OK;
        of->failures += fabs(kt / k - 1) > 1e-9;
        of->sum += k;
        of->failures += strstr(fstiff_last_message(), of->bad_law) == NULL;
    }
    for (int i = 0; i < 10; ++i) { /* what reads and what measures keeps no state either */
        fstiff_contact* read;
        of->failures += fstiff_contact_of_scene(small_scene, strlen(small_scene), NULL, 0, 0, &read) != FSTIFF_OK;
        fstiff_contact_free(read);
        double heights[400];
        fstiff_surface surface = {.size = sizeof surface};
        const fstiff_measure_options options = {.size = sizeof options, .resamples = 5};
        for (int j = 0; j < 400; ++j) heights[j] = 1e-6 * sin(0.7 * j) + 1e-7 * (j * 7919 % 101);
        of->failures += fstiff_measure_profile(heights, 400, 1e-6, &options, &surface) != FSTIFF_OK;
    }
    return NULL;
}

static void test_threads(void) {
    fstiff_contact* contact = contact_of("hertz");
    fstiff_law* law;
    OK(fstiff_law_make(contact, 1e5, 1e8, FSTIFF_OUTSIDE_REFUSE, &law));
    task tasks[2] = {{contact, law, "left", 0, 0}, {contact, law, "right", 0, 0}};
    pthread_t threads[2];
    for (int i = 0; i < 2; ++i) CHECK(pthread_create(&threads[i], NULL, work, &tasks[i]) == 0);
    for (int i = 0; i < 2; ++i) CHECK(pthread_join(threads[i], NULL) == 0);
    CHECK(tasks[0].failures == 0 && tasks[1].failures == 0);
    CHECK(tasks[0].sum > 0 && tasks[0].sum == tasks[1].sum);
    CHECK(strcmp(fstiff_last_message(), "") == 0);
    fstiff_law_free(law);
    fstiff_contact_free(contact);
}

/* ---- Random bytes ---- */

static uint64_t state = 2014;
static uint64_t random_number(void) {
    state ^= state << 13, state ^= state >> 7, state ^= state << 17;
    return state;
}

/* Half of the texts of a changed law get the sum of their lines, to be read further. */
static size_t sum_of_some(char* text, size_t length) {
    size_t last = length;
    while (last > 1 && text[last - 2] != '\n') --last;
    if (random_number() % 2 == 0 || last <= 1) return length;
    uint64_t sum = 0xcbf29ce484222325;
    for (size_t i = 0; i + 1 < last; ++i)
        if (text[i] != '\r') sum = (sum ^ (unsigned char)text[i]) * 0x100000001b3;
    return last - 1 + (size_t)snprintf(text + last - 1, 32, "%" PRIx64 "\n", sum);
}

static void test_random(double seconds, const char* scene_file) {
    size_t scene_length = 0, law_length = 0, accepted = 0, refused = 0;
    char* scene = scene_file ? read_file(scene_file, &scene_length) : NULL;
    fstiff_contact* hertz = contact_of("hertz");
    fstiff_law* law;
    OK(fstiff_law_make(hertz, 1e5, 1e6, FSTIFF_OUTSIDE_CLAMP, &law));
    OK(fstiff_law_text(law, NULL, 0, &law_length));
    char* law_text = malloc(law_length + 1);
    char* bytes = malloc(scene_length + law_length + 4096);
    if (!law_text || !bytes) exit(1);
    OK(fstiff_law_text(law, law_text, law_length + 1, &law_length));
    fstiff_law_free(law);
    fstiff_contact_free(hertz);
    const time_t end = time(NULL) + (time_t)seconds;
    while (time(NULL) <= end) {
        const uint64_t kind = random_number() % 4; /* 0: bytes alone, 1 and 2: a changed scene, 3: a changed law */
        const char* base = kind == 3 ? law_text : scene;
        size_t length = kind == 3 ? law_length : scene_length;
        if (kind == 0 || !base) {
            length = random_number() % 2000;
            for (size_t i = 0; i < length; ++i) bytes[i] = (char)random_number();
        } else {
            memcpy(bytes, base, length);
            for (uint64_t changes = 1 + random_number() % 6; changes > 0; --changes) {
                const size_t at = random_number() % length;
                if (random_number() % 8 == 0)
                    length = at + 1;
                else if (random_number() % 2 == 0)
                    bytes[at] = (char)random_number();
                else
                    bytes[at] = "0123456789.eE-+[]{}=\"'# \nxnaif"[random_number() % 31];
            }
        }
        const double x = pow(10, -10 + (double)(random_number() % 20));
        int status;
        if (kind == 3) {
            double p = 0, k = 0, s = 0;
            status = fstiff_law_of_text(bytes, sum_of_some(bytes, length), &law);
            if (status == FSTIFF_OK) {
                if (fstiff_law_at_separation(law, x, &p, &k, &s) == FSTIFF_OK)
                    CHECK(isfinite(p) && isfinite(k) && isfinite(s));
                if (fstiff_law_at_pressure(law, x, &p, &k, &s) == FSTIFF_OK)
                    CHECK(isfinite(p) && isfinite(k) && isfinite(s));
                fstiff_law_free(law);
            }
        } else {
            fstiff_contact* contact;
            status = fstiff_contact_of_scene(bytes, length, NULL, 0, 0, &contact);
            CHECK((status == FSTIFF_OK) == (contact != NULL));
            if (contact) {
                double k = -1;
                const fstiff_points points = {.size = sizeof points, .stiffness = &k};
                (void)fstiff_contact_at_pressures(contact, &x, 1, &points);
                CHECK(isfinite(k));
                fstiff_contact_free(contact);
            }
        }
        CHECK(status != FSTIFF_INTERNAL);
        if (status == FSTIFF_OK)
            ++accepted;
        else {
            ++refused;
            CHECK(strlen(fstiff_last_message()) > 0);
        }
        if (failures > 5) break;
    }
    printf("%zu texts: %zu refused, %zu accepted\n", accepted + refused, refused, accepted);
    CHECK(refused > 0);
    free(scene);
    free(law_text);
    free(bytes);
}

int main(int argc, char** argv) {
    const char* const part = argc > 1 ? argv[1] : "";
    if (strcmp(part, "numbers") == 0 && argc == 4) {
        size_t length;
        char* const text = read_file(argv[2], &length);
        char scene[1024];
        all_numbers = text;
        snprintf(scene, sizeof scene, "%s.scene", argv[3]);
        test_contacts();
        test_laws();
        test_scene(scene);
        test_law(argv[3]);
        test_tangents();
        test_answer();
        test_law_of_answer();
        test_laws_after_a_load();
        test_motion();
        test_measurement();
        free(text);
    } else if (strcmp(part, "refusals") == 0)
        test_refusals(), test_refusals_of_friction(), test_refusals_of_law_of_answer();
    else if (strcmp(part, "threads") == 0)
        test_threads();
    else if (strcmp(part, "random") == 0 && argc > 2)
        test_random(atof(argv[2]), argc > 3 ? argv[3] : NULL);
    else
        return 2;
    printf("%s: %d failures\n", part, failures);
    return failures > 0;
}
