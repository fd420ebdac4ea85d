/* SPDX-License-Identifier: BSD-3-Clause */
#include <fstiff.h>
#include <stdio.h>

int main(void) {
    fstiff_face face = {
        .size = sizeof face, .rms_height = 1e-6, .peak_radius = 40e-6, .peak_density = 5e8, .theta = 1.0};
    fstiff_joint joint = {.size = sizeof joint, .face = &face, .effective_modulus = 112.6e9};
    fstiff_contact* contact = NULL;
    fstiff_law* law = NULL;
    fstiff_friction* friction = NULL;
    double ratio, d, lost, loss_factor;
    if (fstiff_tangential_ratio(205e9, 0.3, 205e9, 0.3, &ratio) != FSTIFF_OK ||
        fstiff_contact_make("hertz", &joint, &contact) != FSTIFF_OK ||
        fstiff_law_make(contact, 1e5, 1e8, FSTIFF_OUTSIDE_EXTRAPOLATE, &law) != FSTIFF_OK ||
        fstiff_friction_make(law, 0.3, ratio, &friction) != FSTIFF_OK ||
        fstiff_law_at_pressure(law, 1e7, &d, NULL, NULL) != FSTIFF_OK) {
        puts(fstiff_last_message());
        return 1;
    }
    if (fstiff_friction_cycle(friction, d, 1e-7, &lost, &loss_factor) == FSTIFF_OK)
        printf("a cycle between -0.1 and 0.1 um loses %.4e J/m^2, loss factor %.4f\n", lost, loss_factor);

    fstiff_slip place = {.size = sizeof place, .separation = d}; /* one integration point */
    const double slips[][2] = {{1e-7, 0}, {-1e-7, 0}, {1e-4, 0}};
    for (int i = 0; i < 3; ++i) {
        double p, q[2], tangent[9]; /* where an increment is not accepted, keep what was before */
        if (fstiff_friction_step(friction, &place, d, slips[i], &place, &p, q, tangent) != FSTIFF_OK) return 1;
        printf("p = %.4e Pa, q = %11.4e Pa, dq/ds = %.4e Pa/m\n", p, q[0], tangent[4]);
    }
    fstiff_friction_free(friction);
    fstiff_law_free(law);
    fstiff_contact_free(contact);
    return 0;
}
