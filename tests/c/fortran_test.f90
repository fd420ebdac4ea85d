! SPDX-License-Identifier: BSD-3-Clause
! The Fortran module. Truth: numbers.cpp, bit for bit, whose file is the first argument; the second is that of a law.
program fortran_test
    use fstiff
    implicit none
    type(fstiff_points) :: points
    type(fstiff_law_facts) :: facts
    type(fstiff_measure_options) :: options
    type(fstiff_surface) :: surface
    type(c_ptr) :: contact, law, same, other, document, friction, frictions(1)
    type(fstiff_motion) :: motion
    real(c_double), target :: separations(2), slips(4)
    type(fstiff_slip) :: before, after
    type(fstiff_heights), target :: array
    type(fstiff_measured_curve) :: curve
    type(fstiff_face), target :: face
    type(fstiff_joint) :: joint
    type(fstiff_answer_points) :: answer
    real(c_double), target :: low(2)
    integer(c_int), target :: law_of_answer(2)
    integer(c_int) :: doubtful
    real(c_double), allocatable, target :: generated(:)
    integer(c_size_t) :: count
    real(c_double), allocatable :: pressures(:), wanted(:), heights(:)
    real(c_double), target :: stiffness(7), separation(7)
    integer(c_int), target :: status(7)
    real(c_double) :: p, k, slope, batch_p(1), batch_k(1), traction(2), tangent(3, 3)
    real(c_double), parameter :: quantiles(3) = [0.05d0, 0.5d0, 0.95d0]
    character(1024) :: numbers, law_file
    character(:), allocatable :: text
    character(*), parameter :: scene = "surface = { rms_height = '1 um', rms_gradient = 0.1, alpha = 5 }"//achar(10)// &
        "material.upper = { youngs_modulus = '205 GPa', poisson_ratio = 0.3 }"//achar(10)// &
        "contact.pressures = ['10 MPa', '20 MPa']"
    integer :: failures, i

    failures = 0
    call get_command_argument(1, numbers)
    call get_command_argument(2, law_file)
    call check(points%size == c_sizeof(points) .and. &
        facts%size == c_sizeof(facts) .and. options%size == c_sizeof(options) .and. surface%size == c_sizeof(surface) .and. &
        face%size == c_sizeof(face) .and. joint%size == c_sizeof(joint) .and. answer%size == c_sizeof(answer) .and. &
        array%size == c_sizeof(array) .and. curve%size == c_sizeof(curve) .and. before%size == c_sizeof(before) .and. &
        motion%size == c_sizeof(motion), "sizes")

    face = fstiff_face(rms_height=0.832d-6, peak_radius=40d-6, peak_density=500d6, r=0.5d0, theta=1d0)
    joint = fstiff_joint(face=c_loc(face), effective_modulus=112.6d9)
    call check(fstiff_make_contact("hertz", joint, contact) == FSTIFF_OK, "contact")
    points%stiffness = c_loc(stiffness)
    points%separation = c_loc(separation)
    points%status = c_loc(status)
    call read_numbers("pressures", pressures)
    call check(fstiff_contact_at_pressures(contact, pressures, 7_c_size_t, points) == FSTIFF_OK, "points")
    do i = 1, 7
        call read_numbers("hertz/p"//achar(iachar("0") + i - 1), wanted)
        call check(bits(separation(i)) == bits(wanted(2)) .and. bits(stiffness(i)) == bits(wanted(3)) .and. &
            status(i) == FSTIFF_OK, "point")
    end do

    call check(fstiff_law_make(contact, 1d5, 1d8, FSTIFF_OUTSIDE_EXTRAPOLATE, law) == FSTIFF_OK, "law")
    text = fstiff_text_of_law(law)
    call check(text == file_text(trim(law_file)), "text of the law")
    call check(fstiff_law_from_text(text, same) == FSTIFF_OK, "law of text")
    call read_numbers("law/3", wanted)
    call check(fstiff_law_at_separation(same, wanted(2), p, k, slope) == FSTIFF_OK, "separation")
    call check(all(bits([p, k, slope]) == bits(wanted(5:7))), "law at separation")
    call check(fstiff_law_at_separations(same, wanted(2:2), 1_c_size_t, batch_p, batch_k, c_null_ptr) == FSTIFF_OK, "batch")
    call check(abs(batch_p(1)/p - 1) < 1d-13 .and. abs(batch_k(1)/k - 1) < 1d-13, "batch is the scalar call")
    call check(fstiff_law_tangents_at_separations(same, wanted(2:2), 1_c_size_t, batch_p, batch_k, c_null_ptr) == &
        FSTIFF_OK, "batch of tangents")
    call check(abs(batch_p(1)/p - 1) < 1d-13 .and. abs(batch_k(1)/slope - 1) < 1d-13, "tangents are the scalar call")
    call check(fstiff_law_facts_of(same, facts) == FSTIFF_OK .and. facts%max_pressure >= 1d8, "facts")

    call read_numbers("friction", wanted)
    call check(fstiff_tangential_ratio(205d9, 0.3d0, 70d9, 0.33d0, k) == FSTIFF_OK, "ratio")
    call check(bits(k) == bits(wanted(1)), "ratio of C++")
    call check(fstiff_friction_make(same, 0.3d0, k, friction) == FSTIFF_OK, "friction")
    call check(fstiff_friction_first_slip(friction, wanted(2), 1d-7, p, k) == FSTIFF_OK, "first slip")
    call check(all(bits([p, k]) == bits(wanted(3:4))), "first slip of C++")
    call check(fstiff_friction_cycle(friction, wanted(2), 1d-7, p, k) == FSTIFF_OK, "cycle")
    call check(all(bits([p, k]) == bits(wanted(5:6))), "cycle of C++")
    call check(fstiff_law_energy(same, wanted(2), p) == FSTIFF_OK, "energy")
    call check(fstiff_law_touch(same, k) == FSTIFF_OK, "touch")
    call check(all(bits([p, k]) == bits(wanted(7:8))), "energy and touch of C++")
    after = fstiff_slip(separation=wanted(2))
    do i = 1, 40
        before = after
        text = "friction/"
        if (i > 10) text = text//achar(iachar("0") + (i - 1)/10)
        call read_numbers(text//achar(iachar("0") + mod(i - 1, 10)), wanted)
        call check(fstiff_friction_step(friction, before, wanted(1), wanted(2:3), after, p, traction, tangent) == FSTIFF_OK, "step")
        call check(all(bits([p, traction, tangent(:, 1), tangent(:, 2), tangent(:, 3)]) == bits(wanted(4:15))), "step of C++")
        call check(fstiff_friction_stored_energy(friction, after, k) == FSTIFF_OK, "stored")
        call check(bits(k) == bits(wanted(16)) .and. after%count == nint(wanted(17)), "stored energy of C++")
        call check(all(bits(after%levels(:after%count)) == bits(wanted(18::3))) .and. &
            all(bits(after%drags(1, :after%count)) == bits(wanted(19::3))) .and. &
            all(bits(after%drags(2, :after%count)) == bits(wanted(20::3))), "slip")
    end do
    call check(fstiff_law_after(same, 1d7, 0.1d0, other) == FSTIFF_OK, "an elastic law is its own after a load")
    call fstiff_law_free(other)
    frictions(1) = friction
    motion%contacts = 1
    motion%steps = 2
    separations = wanted(1)
    slips = 1d-9
    motion%separations = c_loc(separations)
    motion%slips = c_loc(slips)
    motion%pressures = c_loc(stiffness)
    call check(fstiff_friction_motion(frictions, 1_c_size_t, motion) == FSTIFF_OK, "motion")
    call check(bits(stiffness(1)) == bits(stiffness(2)) .and. stiffness(1) > 0, "pressure of a motion")
    before%count = 17
    call check(fstiff_friction_step(friction, before, 1d-6, traction, after, p, traction, tangent) == FSTIFF_REFUSED, "count")
    call check(index(fstiff_message(), "count of a slip = 17: must be 0 to 16") > 0, "message of a count")
    call fstiff_friction_free(friction)
    call fstiff_law_free(law)
    call fstiff_law_free(same)
    call fstiff_contact_free(contact)

    text = file_text(trim(law_file)//".scene")
    call check(fstiff_contact_from_scene(text, 1, 1, contact) == FSTIFF_OK, "scene")
    call read_numbers("scene/p3", pressures)
    call read_numbers("scene/k3", wanted)
    call check(fstiff_contact_at_pressures(contact, pressures, 7_c_size_t, points) == FSTIFF_OK, "points of a scene")
    call check(all([(bits(stiffness(i)) == bits(wanted(i)), i=1, 7)]), "K of a scene")
    call fstiff_contact_free(contact)

    call read_numbers("profile", heights)
    call read_numbers("profile/measured", wanted)
    options%lambda_s = FSTIFF_NO_CUT_OFF
    options%lambda_c = FSTIFF_NO_CUT_OFF
    call check(fstiff_measure_profile(heights, size(heights, kind=c_size_t), 1d-6, options, surface) == FSTIFF_OK, "profile")
    call check(bits(surface%rms_height%value) == bits(wanted(1)) .and. bits(surface%theta%error) == bits(wanted(14)), "measured")

    text = "kind = profile"//achar(10)//"hurst = 0.7"//achar(10)//"rms = 1e-6"//achar(10)//"spacing = 1 um"//c_null_char
    call check(fstiff_generate(text, document) == FSTIFF_OK, "generate")
    allocate (generated(size(heights)))
    call check(fstiff_document_numbers(document, "heights_m"//c_null_char, generated, size(generated, kind=c_size_t), count) &
        == FSTIFF_OK .and. count == size(heights), "heights of a document")
    call check(all(bits(generated) == bits(heights)), "generated heights")
    call check(index(fstiff_text_of_document(document), "# made by fstiff") == 1, "text of a document")
    call fstiff_document_free(document)
    array%heights = c_loc(generated)
    array%columns = count
    array%dx = 1d-6
    call check(fstiff_spectrum(c_loc(array), "of = acf"//c_null_char, document) == FSTIFF_OK, "spectrum")
    call check(fstiff_document_numbers(document, "acf.acf.0"//c_null_char, batch_p, 1_c_size_t, count) == FSTIFF_OK .and. &
        bits(batch_p(1)) == bits(1d0), "autocorrelation at lag 0")
    call fstiff_document_free(document)
    call check(fstiff_run(scene, len(scene, kind=c_size_t), "steel"//c_null_char, c_null_char, document) == FSTIFF_OK, "run")
    call check(fstiff_document_numbers(document, "answer.*.pressure_Pa"//c_null_char, separation, 7_c_size_t, count) &
        == FSTIFF_OK .and. count == 2 .and. bits(separation(2)) == bits(2d7), "pressures of an answer")
    call check(len(fstiff_word_of_document(document, "answer.1.law")) > 4, "law of an answer")
    call check(fstiff_word_of_document(document, "answer.2.law") == "", "no third row")
    face = fstiff_face(rms_height=1d-6, rms_gradient=0.1d0, alpha=5d0)
    joint = fstiff_joint(face=c_loc(face), upper=fstiff_solid(205d9, 0.3d0), lower=fstiff_solid(205d9, 0.3d0))
    answer%stiffness = c_loc(stiffness); answer%stiffness_p05 = c_loc(low); answer%law = c_loc(law_of_answer)
    call check(fstiff_answer(joint, [1d7, 2d7], 2_c_size_t, answer, doubtful) == FSTIFF_OK .and. doubtful == 0, "answer")
    call check(fstiff_document_numbers(document, "answer.*.stiffness_Pa_per_m"//c_null_char, separation, 7_c_size_t, count) &
        == FSTIFF_OK .and. count == 2, "stiffness of a scene")
    call check(all(bits(separation(:2)) == bits(stiffness(:2))), "stiffness of an answer")
    call check(fstiff_document_numbers(document, "answer.*.stiffness_p05_Pa_per_m"//c_null_char, separation, 7_c_size_t, count) &
        == FSTIFF_OK .and. count == 2, "band of a scene")
    call check(all(bits(separation(:2)) == bits(low)), "band of an answer")
    call check(fstiff_name_of_law(law_of_answer(1)) == fstiff_word_of_document(document, "answer.0.law"), "law by its name")
    face = fstiff_face(rms_height=1d-6, rms_gradient=0.1d0)
    joint%upper%youngs_modulus = 210d9; joint%upper%hardness = 2d9; joint%lower = joint%upper
    call read_numbers("answer/pressures", pressures)
    call read_numbers("answer/laws", wanted)
    do i = 1, 3
        call check(fstiff_answer_law(joint, pressures, 21_c_size_t, quantiles(i), 0d0, 0d0, FSTIFF_OUTSIDE_EXTRAPOLATE, same) &
            == FSTIFF_OK, "law of an answer")
        call check(fstiff_law_at_pressure(same, pressures(11), p, k, slope) == FSTIFF_OK .and. &
            bits(p) == bits(wanted(63*i - 32)) .and. bits(k) == bits(wanted(63*i - 31)), "state of the law of an answer")
        call fstiff_law_free(same)
    end do
    call check(fstiff_name_of_cause(FSTIFF_CAUSE_LONG_WAVES) == "long_waves", "cause by its name")
    call check(FSTIFF_CAUSE_FORM == FSTIFF_CAUSES - 1, "number of causes")
    call fstiff_document_free(document)

    face%rms_height = -1
    call check(fstiff_make_contact("hertz", joint, contact) == FSTIFF_REFUSED, "refusal")
    call check(index(fstiff_message(), "rms_height = -1: must be") > 0 .and. .not. c_associated(contact), "message")
    call check(fstiff_error_text(FSTIFF_OK) == "no error", "words of a status")
    text = fstiff_version()
    call check(len(text) >= 5, "version")
    deallocate (pressures, wanted, heights, generated, text) ! those of a main program are kept, which a leak sanitizer reports
    if (failures > 0) error stop 1
    print *, "fortran: 0 failures"

contains

    subroutine check(good, what)
        logical, intent(in) :: good
        character(*), intent(in) :: what
        if (good) return
        failures = failures + 1
        print *, "failed: ", what, "; message: ", fstiff_message()
    end subroutine

    elemental function bits(x)
        real(c_double), intent(in) :: x
        integer(c_int64_t) :: bits
        bits = transfer(x, bits)
    end function

    function file_text(name) result(text)
        character(*), intent(in) :: name
        character(:), allocatable :: text
        integer :: unit, length
        open (newunit=unit, file=name, access="stream", form="unformatted", status="old", action="read")
        inquire (unit=unit, size=length)
        allocate (character(length) :: text)
        read (unit) text
        close (unit)
    end function

    ! The values of the line "key count values...", which are hexadecimal: by strtod of C.
    subroutine read_numbers(key, values)
        character(*), intent(in) :: key
        real(c_double), allocatable, intent(out) :: values(:)
        interface
            function strtod(text, rest) bind(c) result(value)
                import
                character(kind=c_char), intent(in) :: text(*)
                type(c_ptr), value :: rest
                real(c_double) :: value
            end function
        end interface
        character(:), allocatable :: all
        integer :: at, count, i
        all = achar(10)//file_text(trim(numbers))//achar(0)
        at = index(all, achar(10)//key//" ") + len(key) + 2
        read (all(at:at + index(all(at:), " ") - 2), *) count
        allocate (values(count))
        do i = 1, count
            at = at + index(all(at:), " ")
            values(i) = strtod(all(at:at + 40), c_null_ptr)
        end do
    end subroutine
end program
