! SPDX-License-Identifier: BSD-3-Clause
!
! The contact of two rough faces as the user subroutine UINTER of Abaqus/Standard, over the Fortran module of fstiff. The
! interface is a surface interaction of the model with these properties, in consistent units of the model, such as mm, N, MPa:
!
!     *SURFACE INTERACTION, NAME=ROUGH, USER, UNSYMM, PROPERTIES=15, DEPVAR=50
!     1.0                                      (Abaqus: the thickness in plane models, else a blank line)
!     1, 0.832e-3, 40e-3, 500, 0.5, 1, 1.62, 0
!     112.6e3, 0, 0.1, 100, 2.2e-3, 0.3, 0.8235
!
!      1  law: 1 hertz, 2 fractal_consistent, 3 hybrid, 4 plastic
!      2  sigma, rms height                    6  theta [rad]                           10  hardness, for law 4
!      3  R, peak radius                       7  D, fractal dimension, for law 2       11  least pressure of the table
!      4  D_p, peaks per area                  8  rms gradient, for law 3               12  greatest pressure of the table
!      5  r                                    9  effective modulus                     13  separation of the mean planes where
!     14  coefficient of friction             15  K_t/K_n, 2 (1-nu)/(2-nu) of like          the drawn faces touch
!                                                 bodies
!
! 0 stands for what a law does not need. The pressure is p(d), d = PROPS(13) - RDISP(1), and the tangent -dp/dd, its exact
! derivative; below the least pressure of the table p falls exponentially, above the greatest it goes on with a quadratic.
!
! Where the coefficient of friction is 0 there is no friction; then PROPERTIES=13, DEPVAR=1 is enough. Else STRESS(2:) follows
! partial slip and its history, as fstiff_friction_step does: DRDISP(2:) is the slip, and DDSDDR is full, and not symmetric where
! something slips, which Abaqus uses with UNSYMM alone (and UNSYMM=YES of *STEP). Law 4 has no friction.
!
! State variables, which begin as 0:
!
!      1      RDISP(1) of the last general step
!      2      with friction 1 + the number of levels that are dragged; 0: there was no step
!      3-18   those levels, as separations
!     19-50   how far each is dragged, in both directions; DROT turns them
!
! A linear perturbation step, such as *FREQUENCY, takes the stiffness at the first of them, in friction that of a contact that
! sticks; without it the step is refused. SED is the elastic energy of the contact, of law 4 the work that closed it, SFD what an
! increment loses in friction, by Simpson's rule: a cycle in four increments to 1e-3, in eighty to 1e-8.
!
! The law of a set of properties is made at the first call that brings it, and kept. Programs that call from several threads at
! once must compile this file with OpenMP: the search for the law is a critical section.
!
! Arguments: Abaqus User Subroutines Reference Guide, UINTER. Checked by harness.c; it was not run in Abaqus.
include 'fstiff.f90'

module fstiff_uinter
    use fstiff
    implicit none
    private
    public :: rough_contact

    integer, parameter :: many = 64, least_properties = 13, properties = 15, slip_variables = 2 + 3*FSTIFF_SLIP_LEVELS
    type :: known_law
        real(c_double) :: props(properties) = 0
        type(c_ptr) :: law = c_null_ptr, friction = c_null_ptr
    end type
    type(known_law), save :: known(many)
    integer, save :: count = 0

    interface
        ! Ends the analysis; Abaqus has it.
        subroutine xit() bind(c, name="xit_")
        end subroutine
    end interface

contains

    ! What both entries below do; the arguments of UINTER that are not here stay as they are.
    subroutine rough_contact(stress, ddsddr, statev, sed, sfd, rdisp, drdisp, drot, props, ndir, nstatv, nprops, linper)
        integer(c_int), intent(in) :: ndir, nstatv, nprops, linper
        real(c_double), intent(inout) :: stress(ndir), ddsddr(ndir, ndir), statev(nstatv), sed, sfd
        real(c_double), intent(in) :: rdisp(ndir), drdisp(ndir), drot(2, 2), props(nprops)
        type(known_law) :: of
        integer(c_int) :: status

        stress = 0
        ddsddr = 0
        of = law_of(props, nprops)
        if (.not. c_associated(of%law)) return
        if (linper == 1 .and. nstatv < 1) then
            call stop_with("a linear perturbation step needs DEPVAR=1")
            return
        else if (c_associated(of%friction) .and. nstatv < slip_variables) then
            call stop_with("friction needs DEPVAR=50")
            return
        end if
        if (linper == 1) then
            status = stuck(of, stress, ddsddr, statev(1), rdisp)
        else if (c_associated(of%friction)) then
            status = rubbed(of, stress, ddsddr, statev, sed, sfd, rdisp, drdisp, drot)
        else
            status = pressed(of, stress, ddsddr, sed, rdisp(1))
            if (nstatv >= 1) statev(1) = rdisp(1)
        end if
        if (status /= FSTIFF_OK) call stop_with(fstiff_message())
    end subroutine

    ! Small changes of the state that statev(1) holds: nothing slips.
    function stuck(of, stress, ddsddr, overclosure, rdisp) result(status)
        type(known_law), intent(in) :: of
        real(c_double), intent(inout) :: stress(:), ddsddr(:, :)
        real(c_double), intent(in) :: overclosure, rdisp(:)
        integer(c_int) :: status
        real(c_double) :: pressure, stiffness, slope
        integer :: i

        status = fstiff_law_at_separation(of%law, of%props(13) - overclosure, pressure, stiffness, slope)
        if (status /= FSTIFF_OK) return
        ddsddr(1, 1) = slope
        if (c_associated(of%friction)) then
            do i = 2, size(stress)
                ddsddr(i, i) = of%props(15)*slope
            end do
        end if
        stress = matmul(ddsddr, rdisp)
    end function

    ! Without friction. Far from every partner RDISP(1) is -1e36: p = 0.
    function pressed(of, stress, ddsddr, sed, overclosure) result(status)
        type(known_law), intent(in) :: of
        real(c_double), intent(inout) :: stress(:), ddsddr(:, :), sed
        real(c_double), intent(in) :: overclosure
        integer(c_int) :: status
        real(c_double) :: stiffness

        status = fstiff_law_energy(of%law, of%props(13) - overclosure, sed)
        if (status == FSTIFF_OK) &
            status = fstiff_law_at_separation(of%law, of%props(13) - overclosure, stress(1), stiffness, ddsddr(1, 1))
    end function

    function rubbed(of, stress, ddsddr, statev, sed, sfd, rdisp, drdisp, drot) result(status)
        type(known_law), intent(in) :: of
        real(c_double), intent(inout) :: stress(:), ddsddr(:, :), statev(:), sed, sfd
        real(c_double), intent(in) :: rdisp(:), drdisp(:), drot(2, 2)
        integer(c_int) :: status
        type(fstiff_slip) :: before, after
        real(c_double) :: slip(2), pressure, traction(2), tangent(3, 3), energy, stored
        integer :: directions

        directions = size(stress)
        slip = 0
        slip(:directions - 1) = drdisp(2:)
        before = slip_of(statev, of%props(13), rdisp(1) - drdisp(1), drot)
        status = fstiff_friction_step(of%friction, before, of%props(13) - rdisp(1), slip, after, pressure, traction, tangent)
        if (status == FSTIFF_OK) status = fstiff_law_energy(of%law, after%separation, energy)
        if (status == FSTIFF_OK) status = fstiff_friction_stored_energy(of%friction, after, stored)
        if (status == FSTIFF_OK) status = friction_loss(of%friction, before, after, slip, traction, stored, sfd)
        if (status /= FSTIFF_OK) return
        stress(1) = pressure
        stress(2:) = traction(:directions - 1)
        ddsddr = transpose(tangent(:directions, :directions))
        sed = energy + stored
        statev(1) = rdisp(1)
        statev(2) = 1 + after%count
        statev(3:2 + FSTIFF_SLIP_LEVELS) = after%levels
        statev(3 + FSTIFF_SLIP_LEVELS:slip_variables) = reshape(after%drags, [2*FSTIFF_SLIP_LEVELS])
    end function

    ! What the state variables hold, or a contact that begins at this overclosure.
    function slip_of(statev, touch, overclosure, drot) result(slip)
        real(c_double), intent(in) :: statev(:), touch, overclosure, drot(2, 2)
        type(fstiff_slip) :: slip

        slip = fstiff_slip(separation=touch - overclosure)
        if (nint(statev(2)) == 0) return
        slip%separation = touch - statev(1)
        slip%count = nint(statev(2)) - 1
        slip%levels = statev(3:2 + FSTIFF_SLIP_LEVELS)
        slip%drags = matmul(drot, reshape(statev(3 + FSTIFF_SLIP_LEVELS:slip_variables), [2, FSTIFF_SLIP_LEVELS]))
    end function

    ! The work of the traction on a straight path, by Simpson's rule, less what is stored of it. It is 0 where nothing slips, and
    ! rounding does not make it less.
    function friction_loss(friction, before, after, slip, end, stored, loss) result(status)
        type(c_ptr), intent(in) :: friction
        type(fstiff_slip), intent(in) :: before, after
        real(c_double), intent(in) :: slip(2), end(2), stored
        real(c_double), intent(inout) :: loss
        integer(c_int) :: status
        type(fstiff_slip) :: passed
        real(c_double) :: pressure, begin(2), middle(2), tangent(3, 3), half, stored_before

        half = before%separation + (after%separation - before%separation)/2
        status = fstiff_friction_stored_energy(friction, before, stored_before)
        if (status == FSTIFF_OK) &
            status = fstiff_friction_step(friction, before, before%separation, 0*slip, passed, pressure, begin, tangent)
        if (status == FSTIFF_OK) &
            status = fstiff_friction_step(friction, before, half, slip/2, passed, pressure, middle, tangent)
        if (status == FSTIFF_OK) loss = max(0d0, dot_product(begin + 4*middle + end, slip)/6 - (stored - stored_before))
    end function

    ! The law of these properties; one without a law after stop_with.
    function law_of(props, nprops) result(found)
        integer(c_int), intent(in) :: nprops
        real(c_double), intent(in) :: props(nprops)
        type(known_law) :: found
        integer :: i

        if (nprops /= least_properties .and. nprops /= properties) then
            call stop_with("PROPERTIES must be 13 or 15")
            return
        end if
        found%props(:nprops) = props
        !$omp critical (fstiff_uinter_laws)
        do i = 1, count
            if (all(abs(known(i)%props - found%props) <= 0)) found = known(i)
        end do
        if (.not. c_associated(found%law)) then
            if (count == many) then
                call stop_with("more than 64 sets of properties")
            else
                call make_law(found)
                if (c_associated(found%law)) then
                    count = count + 1
                    known(count) = found
                end if
            end if
        end if
        !$omp end critical (fstiff_uinter_laws)
    end function

    ! The law of made%props, and its friction where there is one.
    subroutine make_law(made)
        type(known_law), intent(inout) :: made
        type(c_ptr) :: contact
        type(fstiff_face), target :: face
        type(fstiff_joint) :: joint
        character(18), parameter :: names(4) = [character(18) :: "hertz", "fractal_consistent", "hybrid", "plastic_peaks"]
        integer(c_int) :: status
        integer :: number

        number = nint(made%props(1))
        if (number < 1 .or. number > size(names)) then
            call stop_with("property 1, the law, must be 1, 2, 3 or 4")
            return
        end if
        associate (props => made%props)
            face = fstiff_face(rms_height=props(2), peak_radius=props(3), peak_density=props(4), r=props(5), &
                theta=props(6), fractal_dimension=props(7), rms_gradient=props(8))
            joint = fstiff_joint(face=c_loc(face), upper=fstiff_solid(hardness=props(10)), effective_modulus=props(9))
            status = fstiff_make_contact(trim(names(number)), joint, contact)
            if (status == FSTIFF_OK) &
                status = fstiff_law_make(contact, props(11), props(12), FSTIFF_OUTSIDE_EXTRAPOLATE, made%law)
            if (status == FSTIFF_OK .and. abs(props(14)) > 0) &
                status = fstiff_friction_make(made%law, props(14), props(15), made%friction)
        end associate
        if (status /= FSTIFF_OK) then
            call stop_with(fstiff_message())
            call fstiff_law_free(made%law)
            made%law = c_null_ptr
        end if
        call fstiff_contact_free(contact)
    end subroutine

    subroutine stop_with(why)
        character(*), intent(in) :: why
        print '(2a)', " fstiff, UINTER: ", why
        call xit()
    end subroutine
end module

! The entry that compilers with an underscore after the names of Fortran call, gfortran and those of Intel on Linux among them.
! A caller that hands on the lengths of the three names, after all others, hands on what nobody reads.
subroutine fstiff_uinter_underscore(stress, ddsddr, amki, amski, flux, ddfddt, ddsddt, ddfddr, statev, sed, sfd, spd, svd, scd, &
    pnewdt, rdisp, drdisp, temp, dtemp, predef, dpred, time, dtime, freqr, ciname, slname, msname, props, coords, alocaldir, &
    drot, area, chrlngth, node, ndir, nstatv, npred, nprops, mcrd, kstep, kinc, kit, linper, lopenclose, lstate, lsdi, lprint) &
    bind(c, name="uinter_")
    use fstiff_uinter
    include 'uinter_arguments.inc'
    call rough_contact(stress, ddsddr, statev, sed, sfd, rdisp, drdisp, drot, props, ndir, nstatv, nprops, linper)
end subroutine

! The same for callers without.
subroutine fstiff_uinter_plain(stress, ddsddr, amki, amski, flux, ddfddt, ddsddt, ddfddr, statev, sed, sfd, spd, svd, scd, &
    pnewdt, rdisp, drdisp, temp, dtemp, predef, dpred, time, dtime, freqr, ciname, slname, msname, props, coords, alocaldir, &
    drot, area, chrlngth, node, ndir, nstatv, npred, nprops, mcrd, kstep, kinc, kit, linper, lopenclose, lstate, lsdi, lprint) &
    bind(c, name="uinter")
    use fstiff_uinter
    include 'uinter_arguments.inc'
    call rough_contact(stress, ddsddr, statev, sed, sfd, rdisp, drdisp, drot, props, ndir, nstatv, nprops, linper)
end subroutine
