! SPDX-License-Identifier: BSD-3-Clause
!
! fstiff in Fortran 2003: the types and functions of fstiff.h, by iso_c_binding. Compile this file with your program and link
! the library fstiff. What each thing is, its units and its range: fstiff.h. Differences:
!
!   - handles are type(c_ptr), c_null_ptr when there is none;
!   - types set their size themselves;
!   - fstiff_make_contact, fstiff_contact_from_scene and fstiff_law_from_text take Fortran strings;
!   - arrays go by c_loc of a target, or c_null_ptr; entries of a scene are counted from 0, as in C.
!
!     type(fstiff_face), target :: face = fstiff_face(rms_height=0.8d-6, rms_gradient=0.1d0)
!     type(fstiff_joint) :: joint = fstiff_joint(upper=fstiff_solid(210d9, 0.3d0), lower=fstiff_solid(210d9, 0.3d0))
!     type(fstiff_answer_points) :: to
!     real(c_double), target :: stiffness(2), low(2), high(2)
!     joint%face = c_loc(face)
!     to%stiffness = c_loc(stiffness); to%stiffness_p05 = c_loc(low); to%stiffness_p95 = c_loc(high)
!     if (fstiff_answer(joint, [1d6, 1d7], 2_c_size_t, to, doubtful) /= FSTIFF_OK) print *, fstiff_message()
module fstiff
    use, intrinsic :: iso_c_binding
    implicit none
    private :: c_strlen, text_by, text_of

    integer, parameter, private :: size_ = c_size_t

    enum, bind(c)
        enumerator :: FSTIFF_OK = 0, FSTIFF_BAD_ARGUMENT, FSTIFF_REFUSED, FSTIFF_OUT_OF_REACH, FSTIFF_OUT_OF_NUMBERS, &
            FSTIFF_FILE, FSTIFF_OUT_OF_MEMORY, FSTIFF_INTERNAL
    end enum
    enum, bind(c)
        enumerator :: FSTIFF_NO_INTERACTION = 0, FSTIFF_EFFECTIVE_SEPARATION, FSTIFF_INTERACTION_AS_PRINTED
    end enum
    enum, bind(c)
        enumerator :: FSTIFF_OUTSIDE_REFUSE = 0, FSTIFF_OUTSIDE_CLAMP, FSTIFF_OUTSIDE_EXACT, FSTIFF_OUTSIDE_EXTRAPOLATE
    end enum
    enum, bind(c)
        enumerator :: FSTIFF_PEAKS_ISLANDS = 0, FSTIFF_PEAKS_SUMMITS
    end enum
    enum, bind(c)
        enumerator :: FSTIFF_FILTER_GAUSSIAN = 0, FSTIFF_FILTER_ROBUST
    end enum
    real(c_double), parameter :: FSTIFF_NO_CUT_OFF = -1
    integer, parameter :: FSTIFF_SLIP_LEVELS = 16

    ! The sizes are those of the C structs on every platform where a double, a pointer and a size_t have 8 bytes; the test of
    ! this module compares them with c_sizeof.
    type, bind(c) :: fstiff_points
        integer(c_size_t) :: size = 72
        type(c_ptr) :: pressure = c_null_ptr, separation = c_null_ptr, stiffness = c_null_ptr, stiffness_error = c_null_ptr, &
            loading_stiffness = c_null_ptr, real_area_fraction = c_null_ptr, contact_density = c_null_ptr, &
            status = c_null_ptr
    end type
    type, bind(c) :: fstiff_law_facts
        integer(c_size_t) :: size = 56
        real(c_double) :: min_pressure = 0, max_pressure = 0, min_separation = 0, max_separation = 0, relative_error = 0
        integer(c_int) :: stiffness_is_slope = 0, outside = 0
    end type
    ! drags(:, i) is that of levels(i).
    type, bind(c) :: fstiff_slip
        integer(c_size_t) :: size = 408
        real(c_double) :: separation = 0, levels(FSTIFF_SLIP_LEVELS) = 0, drags(2, FSTIFF_SLIP_LEVELS) = 0
        integer(c_int) :: count = 0
    end type
    ! Row after row, as C has them: motion_by(direction, 3, step), tangents(3, 3, step, contact), responses_by as these.
    type, bind(c) :: fstiff_motion
        integer(c_size_t) :: size = 104
        integer(c_size_t) :: contacts = 0, steps = 0
        type(c_ptr) :: separations = c_null_ptr, slips = c_null_ptr
        integer(c_size_t) :: directions = 0
        type(c_ptr) :: motion_by = c_null_ptr
        integer(c_int) :: by_of_each = 0
        type(c_ptr) :: states = c_null_ptr
        type(c_ptr) :: pressures = c_null_ptr, tractions = c_null_ptr, tangents = c_null_ptr, responses_by = c_null_ptr
    end type
    type, bind(c) :: fstiff_measure_options
        integer(c_size_t) :: size = 80
        type(c_ptr) :: detrend = c_null_ptr
        real(c_double) :: lambda_s = 0, lambda_c = 0, tip_radius = 0, resolution = 0, shortest_lag = 0, longest_lag = 0
        integer(c_int) :: filter = FSTIFF_FILTER_GAUSSIAN, peaks = FSTIFF_PEAKS_ISLANDS, resamples = 0, seed = 0
    end type
    type, bind(c) :: fstiff_measured
        real(c_double) :: value = 0, error = 0
        integer(c_int) :: known = 0
    end type
    type, bind(c) :: fstiff_surface
        integer(c_size_t) :: size = 304, peaks = 0
        real(c_double) :: lambda_s = 0, lambda_c = 0, shape_share = 0
        type(fstiff_measured) :: rms_height, peak_radius, peak_density, max_peak_height, fractal_dimension, &
            fractal_roughness, r, theta, rms_gradient, skewness, kurtosis
    end type

    type, bind(c) :: fstiff_heights
        integer(c_size_t) :: size = 48
        type(c_ptr) :: heights = c_null_ptr
        integer(c_size_t) :: rows = 0, columns = 0
        real(c_double) :: dx = 0, dy = 0
    end type
    enum, bind(c)
        enumerator :: FSTIFF_PROCESS_UNKNOWN = 0, FSTIFF_PROCESS_GROUND, FSTIFF_PROCESS_TURNED, FSTIFF_PROCESS_MILLED, &
            FSTIFF_PROCESS_HONED, FSTIFF_PROCESS_LAPPED, FSTIFF_PROCESS_POLISHED, FSTIFF_PROCESS_BLASTED, FSTIFF_PROCESS_ERODED, &
            FSTIFF_PROCESS_SUPERFINISHED
    end enum
    ! Places of a cause in a row of causes, counted from 0.
    enum, bind(c)
        enumerator :: FSTIFF_CAUSE_MEASUREMENT = 0, FSTIFF_CAUSE_CUT_OFFS, FSTIFF_CAUSE_SHAPE, FSTIFF_CAUSE_PRIOR, &
            FSTIFF_CAUSE_LAY, FSTIFF_CAUSE_LAW, FSTIFF_CAUSE_CONTACTS, FSTIFF_CAUSE_LONG_WAVES, FSTIFF_CAUSE_HARDNESS, &
            FSTIFF_CAUSE_NOISE, FSTIFF_CAUSE_FORM, FSTIFF_CAUSES
    end enum
    ! heights and options are c_loc of a target, or c_null_ptr; so are face and other of a joint.
    type, bind(c) :: fstiff_face_errors
        real(c_double) :: height = 0, gradient = 0, peak_radius = 0, peak_density = 0, fractal_dimension = 0, r = 0, theta = 0
    end type
    type, bind(c) :: fstiff_face
        integer(c_size_t) :: size = 216
        type(c_ptr) :: heights = c_null_ptr, options = c_null_ptr
        real(c_double) :: rms_height = 0, mean_height = 0, rms_gradient = 0, profile_gradient = 0, profile_spacing = 0, &
            alpha = 0, hurst = 0, skewness = 0, kurtosis = 0, peak_radius = 0, peak_density = 0, max_peak_height = 0, r = 0, &
            theta = 0, fractal_dimension = 0, fractal_roughness = 0
        type(fstiff_face_errors) :: errors
        integer(c_int) :: process = FSTIFF_PROCESS_UNKNOWN
    end type
    type, bind(c) :: fstiff_solid
        real(c_double) :: youngs_modulus = 0, poisson_ratio = 0, yield_strength = 0, hardness = 0
    end type
    type, bind(c) :: fstiff_joint
        integer(c_size_t) :: size = 160
        type(c_ptr) :: face = c_null_ptr, other = c_null_ptr
        type(fstiff_solid) :: upper, lower
        real(c_double) :: effective_modulus = 0, nominal_area = 0, interaction_length = 0
        integer(c_int) :: interaction = FSTIFF_NO_INTERACTION, shifts = 0
        real(c_double) :: seating = 0
        integer(c_int) :: samples = 0, seed = 0
        integer(c_size_t) :: number_count = 0
        type(c_ptr) :: names = c_null_ptr, numbers = c_null_ptr
    end type
    type, bind(c) :: fstiff_answer_points
        integer(c_size_t) :: size = 120
        type(c_ptr) :: stiffness = c_null_ptr, stiffness_p05 = c_null_ptr, stiffness_p95 = c_null_ptr, &
            loading_stiffness = c_null_ptr, tangential_stiffness = c_null_ptr, approach = c_null_ptr, contacts = c_null_ptr, &
            p_star = c_null_ptr, causes = c_null_ptr, law = c_null_ptr, status = c_null_ptr
        integer(c_size_t) :: key_count = 0
        type(c_ptr) :: keys = c_null_ptr, numbers = c_null_ptr
    end type
    type, bind(c) :: fstiff_measured_curve
        integer(c_size_t) :: size = 48
        type(c_ptr) :: pressures = c_null_ptr, values = c_null_ptr, errors = c_null_ptr
        integer(c_size_t) :: count = 0
        integer(c_int) :: is_reflection = 0
    end type

    interface
        function fstiff_answer(joint, pressures, count, points, doubtful) bind(c) result(status)
            import
            type(fstiff_joint), intent(in) :: joint
            real(c_double), intent(in) :: pressures(*)
            integer(c_size_t), value :: count
            type(fstiff_answer_points), intent(in) :: points
            integer(c_int), intent(out) :: doubtful
            integer(c_int) :: status
        end function
        function fstiff_answer_law(joint, pressures, count, quantile, min_pressure, max_pressure, outside, made) bind(c) &
            result(status)
            import
            type(fstiff_joint), intent(in) :: joint
            real(c_double), intent(in) :: pressures(*)
            integer(c_size_t), value :: count
            real(c_double), value :: quantile, min_pressure, max_pressure
            integer(c_int), value :: outside
            type(c_ptr), intent(out) :: made
            integer(c_int) :: status
        end function
        function fstiff_answer_law_after(joint, pressures, count, quantile, greatest_pressure, min_pressure, max_pressure, &
            outside, made) bind(c) result(status)
            import
            type(fstiff_joint), intent(in) :: joint
            real(c_double), intent(in) :: pressures(*)
            integer(c_size_t), value :: count
            real(c_double), value :: quantile, greatest_pressure, min_pressure, max_pressure
            integer(c_int), value :: outside
            type(c_ptr), intent(out) :: made
            integer(c_int) :: status
        end function
        function fstiff_contact_make(law, joint, made) bind(c) result(status)
            import
            character(kind=c_char), intent(in) :: law(*)
            type(fstiff_joint), intent(in) :: joint
            type(c_ptr), intent(out) :: made
            integer(c_int) :: status
        end function
        function fstiff_contact_of_scene(text, length, name, law, peaks, made) bind(c) result(status)
            import
            character(kind=c_char), intent(in) :: text(*), name(*)
            integer(c_size_t), value :: length, law, peaks
            type(c_ptr), intent(out) :: made
            integer(c_int) :: status
        end function
        subroutine fstiff_contact_free(contact) bind(c)
            import
            type(c_ptr), value :: contact
        end subroutine
        function fstiff_contact_at_pressures(contact, pressures, count, points) bind(c) result(status)
            import
            type(c_ptr), value :: contact
            real(c_double), intent(in) :: pressures(*)
            integer(c_size_t), value :: count
            type(fstiff_points), intent(in) :: points
            integer(c_int) :: status
        end function
        function fstiff_contact_at_separations(contact, separations, count, points) bind(c) result(status)
            import
            type(c_ptr), value :: contact
            real(c_double), intent(in) :: separations(*)
            integer(c_size_t), value :: count
            type(fstiff_points), intent(in) :: points
            integer(c_int) :: status
        end function
        function fstiff_law_make(contact, min_pressure, max_pressure, outside, made) bind(c) result(status)
            import
            type(c_ptr), value :: contact
            real(c_double), value :: min_pressure, max_pressure
            integer(c_int), value :: outside
            type(c_ptr), intent(out) :: made
            integer(c_int) :: status
        end function
        function fstiff_law_after(first_loading, greatest_pressure, relative_hardness, made) bind(c) result(status)
            import
            type(c_ptr), value :: first_loading
            real(c_double), value :: greatest_pressure, relative_hardness
            type(c_ptr), intent(out) :: made
            integer(c_int) :: status
        end function
        function fstiff_law_of_text(text, length, made) bind(c) result(status)
            import
            character(kind=c_char), intent(in) :: text(*)
            integer(c_size_t), value :: length
            type(c_ptr), intent(out) :: made
            integer(c_int) :: status
        end function
        function fstiff_law_text(law, buffer, capacity, length) bind(c) result(status)
            import
            type(c_ptr), value :: law, buffer
            integer(c_size_t), value :: capacity
            integer(c_size_t), intent(out) :: length
            integer(c_int) :: status
        end function
        subroutine fstiff_law_free(law) bind(c)
            import
            type(c_ptr), value :: law
        end subroutine
        function fstiff_law_facts_of(law, facts) bind(c) result(status)
            import
            type(c_ptr), value :: law
            type(fstiff_law_facts), intent(inout) :: facts
            integer(c_int) :: status
        end function
        function fstiff_law_at_separation(law, separation, pressure, stiffness, slope) bind(c) result(status)
            import
            type(c_ptr), value :: law
            real(c_double), value :: separation
            real(c_double), intent(out) :: pressure, stiffness, slope
            integer(c_int) :: status
        end function
        function fstiff_law_at_pressure(law, pressure, separation, stiffness, stiffness_slope) bind(c) result(status)
            import
            type(c_ptr), value :: law
            real(c_double), value :: pressure
            real(c_double), intent(out) :: separation, stiffness, stiffness_slope
            integer(c_int) :: status
        end function
        function fstiff_law_energy(law, separation, energy) bind(c) result(status)
            import
            type(c_ptr), value :: law
            real(c_double), value :: separation
            real(c_double), intent(inout) :: energy
            integer(c_int) :: status
        end function
        function fstiff_law_touch(law, separation) bind(c) result(status)
            import
            type(c_ptr), value :: law
            real(c_double), intent(inout) :: separation
            integer(c_int) :: status
        end function
        function fstiff_law_at_separations(law, separations, count, pressures, stiffnesses, statuses) bind(c) result(status)
            import
            type(c_ptr), value :: law, statuses
            real(c_double), intent(in) :: separations(*)
            integer(c_size_t), value :: count
            real(c_double), intent(out) :: pressures(*), stiffnesses(*)
            integer(c_int) :: status
        end function
        function fstiff_law_tangents_at_separations(law, separations, count, pressures, slopes, statuses) bind(c) &
            result(status)
            import
            type(c_ptr), value :: law, statuses
            real(c_double), intent(in) :: separations(*)
            integer(c_size_t), value :: count
            real(c_double), intent(out) :: pressures(*), slopes(*)
            integer(c_int) :: status
        end function
        function fstiff_law_at_pressures(law, pressures, count, separations, stiffnesses, statuses) bind(c) result(status)
            import
            type(c_ptr), value :: law, statuses
            real(c_double), intent(in) :: pressures(*)
            integer(c_size_t), value :: count
            real(c_double), intent(out) :: separations(*), stiffnesses(*)
            integer(c_int) :: status
        end function
        function fstiff_tangential_ratio(modulus1, poisson1, modulus2, poisson2, ratio) bind(c) result(status)
            import
            real(c_double), value :: modulus1, poisson1, modulus2, poisson2
            real(c_double), intent(inout) :: ratio
            integer(c_int) :: status
        end function
        function fstiff_friction_make(law, friction, ratio, made) bind(c) result(status)
            import
            type(c_ptr), value :: law
            real(c_double), value :: friction, ratio
            type(c_ptr), intent(out) :: made
            integer(c_int) :: status
        end function
        subroutine fstiff_friction_free(friction) bind(c)
            import
            type(c_ptr), value :: friction
        end subroutine
        function fstiff_friction_first_slip(friction, separation, slip, traction, stiffness) bind(c) result(status)
            import
            type(c_ptr), value :: friction
            real(c_double), value :: separation, slip
            real(c_double), intent(inout) :: traction, stiffness
            integer(c_int) :: status
        end function
        function fstiff_friction_cycle(friction, separation, amplitude, lost, loss_factor) bind(c) result(status)
            import
            type(c_ptr), value :: friction
            real(c_double), value :: separation, amplitude
            real(c_double), intent(inout) :: lost, loss_factor
            integer(c_int) :: status
        end function
        ! tangent(j, i) is the derivative of result i by input j, as C has it by rows. before and after are two variables.
        function fstiff_friction_step(friction, before, separation, slip, after, pressure, traction, tangent) bind(c) &
            result(status)
            import
            type(c_ptr), value :: friction
            type(fstiff_slip), intent(in) :: before
            real(c_double), value :: separation
            real(c_double), intent(in) :: slip(2)
            type(fstiff_slip), intent(inout) :: after
            real(c_double), intent(inout) :: pressure, traction(2), tangent(3, 3)
            integer(c_int) :: status
        end function
        function fstiff_friction_motion(frictions, laws, motion) bind(c) result(status)
            import
            type(c_ptr), intent(in) :: frictions(*)
            integer(c_size_t), value :: laws
            type(fstiff_motion), intent(in) :: motion
            integer(c_int) :: status
        end function
        function fstiff_friction_stored_energy(friction, slip, energy) bind(c) result(status)
            import
            type(c_ptr), value :: friction
            type(fstiff_slip), intent(in) :: slip
            real(c_double), intent(inout) :: energy
            integer(c_int) :: status
        end function
        function fstiff_measure_profile(heights, count, spacing, options, surface) bind(c) result(status)
            import
            real(c_double), intent(in) :: heights(*)
            integer(c_size_t), value :: count
            real(c_double), value :: spacing
            type(fstiff_measure_options), intent(in) :: options
            type(fstiff_surface), intent(inout) :: surface
            integer(c_int) :: status
        end function
        ! heights(columns, rows): Fortran's first index runs along x.
        function fstiff_measure_map(heights, rows, columns, dx, dy, options, surface) bind(c) result(status)
            import
            real(c_double), intent(in) :: heights(*)
            integer(c_size_t), value :: rows, columns
            real(c_double), value :: dx, dy
            type(fstiff_measure_options), intent(in) :: options
            type(fstiff_surface), intent(inout) :: surface
            integer(c_int) :: status
        end function
        ! Options end with c_null_char, and have achar(10) between their lines; heights and curve are c_loc of a target, or c_null_ptr.
        function fstiff_spectrum(heights, options, made) bind(c) result(status)
            import
            type(c_ptr), value :: heights
            character(kind=c_char), intent(in) :: options(*)
            type(c_ptr), intent(out) :: made
            integer(c_int) :: status
        end function
        function fstiff_generate(options, made) bind(c) result(status)
            import
            character(kind=c_char), intent(in) :: options(*)
            type(c_ptr), intent(out) :: made
            integer(c_int) :: status
        end function
        function fstiff_ultrasound(curve, options, made) bind(c) result(status)
            import
            type(c_ptr), value :: curve
            character(kind=c_char), intent(in) :: options(*)
            type(c_ptr), intent(out) :: made
            integer(c_int) :: status
        end function
        function fstiff_run(scene, length, name, options, made) bind(c) result(status)
            import
            character(kind=c_char), intent(in) :: scene(*), name(*), options(*)
            integer(c_size_t), value :: length
            type(c_ptr), intent(out) :: made
            integer(c_int) :: status
        end function
        function fstiff_identify(scene, length, name, curve, options, made) bind(c) result(status)
            import
            character(kind=c_char), intent(in) :: scene(*), name(*), options(*)
            integer(c_size_t), value :: length
            type(c_ptr), value :: curve
            type(c_ptr), intent(out) :: made
            integer(c_int) :: status
        end function
        function fstiff_export(scene, length, name, options, made) bind(c) result(status)
            import
            character(kind=c_char), intent(in) :: scene(*), name(*), options(*)
            integer(c_size_t), value :: length
            type(c_ptr), intent(out) :: made
            integer(c_int) :: status
        end function
        function fstiff_document_text(document, buffer, capacity, length) bind(c) result(status)
            import
            type(c_ptr), value :: document, buffer
            integer(c_size_t), value :: capacity
            integer(c_size_t), intent(out) :: length
            integer(c_int) :: status
        end function
        function fstiff_document_word(document, path, buffer, capacity, length) bind(c) result(status)
            import
            type(c_ptr), value :: document, buffer
            character(kind=c_char), intent(in) :: path(*)
            integer(c_size_t), value :: capacity
            integer(c_size_t), intent(out) :: length
            integer(c_int) :: status
        end function
        function fstiff_document_numbers(document, path, values, capacity, count) bind(c) result(status)
            import
            type(c_ptr), value :: document
            character(kind=c_char), intent(in) :: path(*)
            real(c_double), intent(out) :: values(*)
            integer(c_size_t), value :: capacity
            integer(c_size_t), intent(out) :: count
            integer(c_int) :: status
        end function
        function fstiff_document_is_doubtful(document) bind(c) result(doubtful)
            import
            type(c_ptr), value :: document
            integer(c_int) :: doubtful
        end function
        subroutine fstiff_document_free(document) bind(c)
            import
            type(c_ptr), value :: document
        end subroutine
        function fstiff_version_c() bind(c, name="fstiff_version") result(text)
            import
            type(c_ptr) :: text
        end function
        function fstiff_cause_name_c(cause) bind(c, name="fstiff_cause_name") result(text)
            import
            integer(c_int), value :: cause
            type(c_ptr) :: text
        end function
        function fstiff_law_name_c(law) bind(c, name="fstiff_law_name") result(text)
            import
            integer(c_int), value :: law
            type(c_ptr) :: text
        end function
        function fstiff_strerror_c(status) bind(c, name="fstiff_strerror") result(text)
            import
            integer(c_int), value :: status
            type(c_ptr) :: text
        end function
        function fstiff_last_message_c() bind(c, name="fstiff_last_message") result(text)
            import
            type(c_ptr) :: text
        end function
        function c_strlen(text) bind(c, name="strlen") result(length)
            import
            type(c_ptr), value :: text
            integer(c_size_t) :: length
        end function
    end interface

contains

    function fstiff_make_contact(law, joint, made) result(status)
        character(*), intent(in) :: law
        type(fstiff_joint), intent(in) :: joint
        type(c_ptr), intent(out) :: made
        integer(c_int) :: status
        status = fstiff_contact_make(trim(law)//c_null_char, joint, made)
    end function

    function fstiff_contact_from_scene(text, law, peaks, made) result(status)
        character(*), intent(in) :: text
        integer, intent(in) :: law, peaks
        type(c_ptr), intent(out) :: made
        integer(c_int) :: status
        status = fstiff_contact_of_scene(text, len(text, size_), "scene"//c_null_char, int(law, size_), int(peaks, size_), made)
    end function

    function fstiff_law_from_text(text, made) result(status)
        character(*), intent(in) :: text
        type(c_ptr), intent(out) :: made
        integer(c_int) :: status
        status = fstiff_law_of_text(text, len(text, size_), made)
    end function

    ! The text of a law, and that of a document; empty where there is none, and fstiff_message() says why.
    function fstiff_text_of_law(law) result(text)
        type(c_ptr), intent(in) :: law
        character(:), allocatable :: text
        text = text_by(fstiff_law_text, law)
    end function

    function fstiff_text_of_document(document) result(text)
        type(c_ptr), intent(in) :: document
        character(:), allocatable :: text
        text = text_by(fstiff_document_text, document)
    end function

    function fstiff_word_of_document(document, path) result(text) ! "" where path has no text
        type(c_ptr), intent(in) :: document
        character(*), intent(in) :: path
        character(:), allocatable :: text
        character(kind=c_char), allocatable, target :: buffer(:)
        integer(c_size_t) :: length, capacity
        text = ""
        if (fstiff_document_word(document, path//c_null_char, c_null_ptr, 0_size_, length) /= FSTIFF_OK) return
        capacity = length + 1 ! an expression of length could be computed when the call has made it undefined
        allocate (buffer(capacity))
        if (fstiff_document_word(document, path//c_null_char, c_loc(buffer), capacity, length) /= FSTIFF_OK) return
        text = text_of(c_loc(buffer))
    end function

    function text_by(get, from) result(text)
        procedure(fstiff_law_text) :: get
        type(c_ptr), intent(in) :: from
        character(:), allocatable :: text
        character(kind=c_char), allocatable, target :: buffer(:)
        integer(c_size_t) :: length, capacity, i
        text = ""
        if (get(from, c_null_ptr, 0_size_, length) /= FSTIFF_OK) return
        capacity = length + 1
        allocate (buffer(capacity))
        if (get(from, c_loc(buffer), capacity, length) /= FSTIFF_OK) return
        deallocate (text)
        allocate (character(length) :: text)
        do i = 1, length
            text(i:i) = buffer(i)
        end do
    end function

    function fstiff_message() result(text)
        character(:), allocatable :: text
        text = text_of(fstiff_last_message_c())
    end function

    function fstiff_name_of_cause(cause) result(text)
        integer(c_int), intent(in) :: cause
        character(:), allocatable :: text
        text = text_of(fstiff_cause_name_c(cause))
    end function

    function fstiff_name_of_law(law) result(text)
        integer(c_int), intent(in) :: law
        character(:), allocatable :: text
        text = text_of(fstiff_law_name_c(law))
    end function
    function fstiff_error_text(status) result(text)
        integer(c_int), intent(in) :: status
        character(:), allocatable :: text
        text = text_of(fstiff_strerror_c(status))
    end function

    function fstiff_version() result(text)
        character(:), allocatable :: text
        text = text_of(fstiff_version_c())
    end function

    function text_of(pointer) result(text)
        type(c_ptr), intent(in) :: pointer
        character(:), allocatable :: text
        character(kind=c_char), pointer :: characters(:)
        integer :: i, length
        length = int(c_strlen(pointer))
        call c_f_pointer(pointer, characters, [length])
        allocate (character(length) :: text)
        do i = 1, length
            text(i:i) = characters(i)
        end do
    end function
end module
