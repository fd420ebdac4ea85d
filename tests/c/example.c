/* SPDX-License-Identifier: BSD-3-Clause */
#include <fstiff.h>
#include <stdio.h>

int main(void) {
    fstiff_face face = {.size = sizeof face,
                        .rms_height = 0.832e-6,
                        .peak_radius = 40e-6,
                        .peak_density = 500e6,
                        .r = 0.5,
                        .theta = 1.0};
    fstiff_joint joint = {.size = sizeof joint, .face = &face, .effective_modulus = 112.6e9};
    fstiff_contact* contact;
    if (fstiff_contact_make("hertz", &joint, &contact) != FSTIFF_OK) {
        puts(fstiff_last_message());
        return 1;
    }
    double p[] = {1e6, 1e7, -1}, k[3];
    int status[3];
    fstiff_points points = {.size = sizeof points, .stiffness = k, .status = status};
    if (fstiff_contact_at_pressures(contact, p, 3, &points) != FSTIFF_OK) puts(fstiff_last_message());
    for (int i = 0; i < 3; ++i) printf("%g Pa: %.6e Pa/m, %s\n", p[i], k[i], fstiff_strerror(status[i]));

    fstiff_law* law; /* the same in nanoseconds, for the inner loop of a program */
    if (fstiff_law_make(contact, 1e5, 1e8, FSTIFF_OUTSIDE_EXTRAPOLATE, &law) == FSTIFF_OK) {
        double separation, pressure, slope;
        fstiff_law_at_pressure(law, 1e6, &separation, NULL, NULL);
        fstiff_law_at_separation(law, separation, &pressure, NULL, &slope);
        printf("d = %.6e m: p = %.6e Pa, -dp/dd = %.6e Pa/m\n", separation, pressure, slope);
        fstiff_law_free(law);
    }
    fstiff_contact_free(contact);

    fstiff_document* wave; /* and what a command computes, here fstiff ultrasound */
    double reflection;
    size_t count;
    if (fstiff_ultrasound(NULL, "stiffness = 3.18e13\nfrequency = 7 MHz\nimpedance = 46 MRayl", &wave) == FSTIFF_OK &&
        fstiff_document_numbers(wave, "reflection", &reflection, 1, &count) == FSTIFF_OK)
        printf("|R| = %.5f\n", reflection);
    fstiff_document_free(wave);
    return 0;
}
