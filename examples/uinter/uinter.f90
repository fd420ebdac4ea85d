! SPDX-License-Identifier: BSD-3-Clause
!
! The contact of two rough faces as the user subroutine UINTER of Abaqus/Standard, over the Fortran module of fstiff. There is
! no friction. The interface is a surface interaction of the model with these properties, in consistent units of the model,
! such as mm, N, MPa:
!
!     *SURFACE INTERACTION, NAME=ROUGH, USER, PROPERTIES=13, DEPVAR=1
!     1.0                                      (Abaqus: the thickness in plane models, else a blank line)
!     1, 0.832e-3, 40e-3, 500, 0.5, 1, 1.62, 0
!     112.6e3, 0, 0.1, 100, 2.2e-3
!
!      1  law: 1 hertz, 2 fractal_consistent, 3 hybrid, 4 plastic
!      2  sigma, rms height                    6  theta [rad]                           10  hardness, for law 4
!      3  R, peak radius                       7  D, fractal dimension, for law 2       11  least pressure of the table
!      4  D_p, peaks per area                  8  rms gradient, for law 3               12  greatest pressure of the table
!      5  r                                    9  effective modulus                     13  separation of the mean planes where
!                                                                                           the drawn faces touch
!
! 0 stands for what a law does not need. The pressure is p(d), d = PROPS(13) - RDISP(1), and the tangent -dp/dd, its exact
! derivative; below the least pressure of the table p falls exponentially, above the greatest it goes on with a quadratic.
!
! The state variable holds RDISP(1) of the last general step. A linear perturbation step, such as *FREQUENCY, takes the stiffness
! there; without the variable it is refused.
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

    integer, parameter :: many = 64, properties = 13
    type :: known_law
        real(c_double) :: props(properties)
        type(c_ptr) :: law
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
    subroutine rough_contact(stress, ddsddr, statev, sed, rdisp, drdisp, props, ndir, nstatv, nprops, linper)
        integer(c_int), intent(in) :: ndir, nstatv, nprops, linper
        real(c_double), intent(inout) :: stress(ndir), ddsddr(ndir, ndir), statev(nstatv), sed
        real(c_double), intent(in) :: rdisp(ndir), drdisp(ndir), props(nprops)
        real(c_double) :: before, at, pressure, stiffness, slope
        type(c_ptr) :: law

        before = stress(1)
        stress = 0
        ddsddr = 0
        law = law_of(props, nprops)
        if (.not. c_associated(law)) return
        at = rdisp(1)
        if (linper == 1) then
            if (nstatv < 1) then
                call stop_with("a linear perturbation step needs DEPVAR=1")
                return
            end if
            at = statev(1)
        end if
        ! Far from every partner RDISP(1) is -1e36: p = 0.
        if (fstiff_law_at_separation(law, props(13) - at, pressure, stiffness, slope) /= FSTIFF_OK) then
            call stop_with(fstiff_message())
            return
        end if
        ddsddr(1, 1) = slope
        if (linper == 1) then
            stress(1) = slope*rdisp(1)
        else
            stress(1) = pressure
            sed = sed + 0.5d0*(before + pressure)*drdisp(1)
            if (nstatv >= 1) statev(1) = at
        end if
    end subroutine

    ! The law of these properties, or c_null_ptr after stop_with.
    function law_of(props, nprops) result(law)
        integer(c_int), intent(in) :: nprops
        real(c_double), intent(in) :: props(nprops)
        type(c_ptr) :: law
        integer :: i

        law = c_null_ptr
        if (nprops /= properties) then
            call stop_with("PROPERTIES must be 13")
            return
        end if
        !$omp critical (fstiff_uinter_laws)
        do i = 1, count
            if (all(abs(known(i)%props - props) <= 0)) law = known(i)%law
        end do
        if (.not. c_associated(law)) then
            if (count == many) then
                call stop_with("more than 64 sets of properties")
            else
                law = make_law(props)
                if (c_associated(law)) then
                    known(count + 1) = known_law(props, law)
                    count = count + 1
                end if
            end if
        end if
        !$omp end critical (fstiff_uinter_laws)
    end function

    function make_law(props) result(law)
        real(c_double), intent(in) :: props(properties)
        type(c_ptr) :: law, contact
        type(fstiff_roughness) :: surface
        type(fstiff_body) :: body
        character(18), parameter :: names(4) = [character(18) :: "hertz", "fractal_consistent", "hybrid", "plastic_peaks"]
        integer :: number

        law = c_null_ptr
        number = nint(props(1))
        if (number < 1 .or. number > size(names)) then
            call stop_with("property 1, the law, must be 1, 2, 3 or 4")
            return
        end if
        surface = fstiff_roughness(rms_height=props(2), peak_radius=props(3), peak_density=props(4), r=props(5), &
            theta=props(6), fractal_dimension=props(7), rms_gradient=props(8))
        body = fstiff_body(effective_modulus=props(9), hardness=props(10))
        if (fstiff_make_contact(trim(names(number)), surface, body, contact) /= FSTIFF_OK) then
            call stop_with(fstiff_message())
            return
        end if
        if (fstiff_law_make(contact, props(11), props(12), FSTIFF_OUTSIDE_EXTRAPOLATE, law) /= FSTIFF_OK) then
            law = c_null_ptr
            call stop_with(fstiff_message())
        end if
        call fstiff_contact_free(contact)
    end function

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
    call rough_contact(stress, ddsddr, statev, sed, rdisp, drdisp, props, ndir, nstatv, nprops, linper)
end subroutine

! The same for callers without.
subroutine fstiff_uinter_plain(stress, ddsddr, amki, amski, flux, ddfddt, ddsddt, ddfddr, statev, sed, sfd, spd, svd, scd, &
    pnewdt, rdisp, drdisp, temp, dtemp, predef, dpred, time, dtime, freqr, ciname, slname, msname, props, coords, alocaldir, &
    drot, area, chrlngth, node, ndir, nstatv, npred, nprops, mcrd, kstep, kinc, kit, linper, lopenclose, lstate, lsdi, lprint) &
    bind(c, name="uinter")
    use fstiff_uinter
    include 'uinter_arguments.inc'
    call rough_contact(stress, ddsddr, statev, sed, rdisp, drdisp, props, ndir, nstatv, nprops, linper)
end subroutine
