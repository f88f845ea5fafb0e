! ADRX6 for Adore: surfaces of races (kRaceGeoImp1, kRaceGeoImp2 = 3). In this example, the radius of the inner race has
! waves. Record 12.1 contains amplitude [m], number per revolution and phase [rad].
module surface_of_races
  use adore_user
  implicit none
  real(c_double), save :: wave(3)
contains
  integer(c_int32_t) function adrx6(a) bind(c)
    type(adore_surface), intent(inout) :: a
    real(c_double), pointer :: azimuth(:), radius(:)
    adrx6 = 0
    if (a%call%mode == ADORE_READ) then
      a%call%active = 1
      if (adore_numbers(a%call, wave) /= 3) then
        call adore_fail(a%call, 'record 12 must contain amplitude, number and phase of the waves')
        adrx6 = 2
      end if
    end if
    if (a%call%mode /= ADORE_COMPUTE .or. a%race /= 1) return
    call c_f_pointer(a%azimuth, azimuth, [a%n])
    call c_f_pointer(a%radius, radius, [a%n])
    radius = wave(1)*sin(wave(2)*azimuth + wave(3))
  end function
end module
