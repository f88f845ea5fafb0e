! ADRX8 for Adore: record 12.1 contains the increase in diameter of every second element [m] (kReGeoImp = 3).
module imperfections
  use adore_user
  implicit none
  real(c_double), save :: larger(1)
contains
  integer(c_int32_t) function adrx8(a) bind(c)
    type(adore_adrx8), intent(inout) :: a
    real(c_double), pointer :: diameter(:)
    adrx8 = 0
    if (a%call%mode == ADORE_READ) then
      a%call%active = 1
      if (adore_numbers(a%call, larger) /= 1) then
        call adore_fail(a%call, 'record 12 must contain the increase in diameter [m]')
        adrx8 = 2
      end if
    end if
    if (a%call%mode /= ADORE_COMPUTE) return
    call c_f_pointer(a%diameter, diameter, [a%n])
    diameter(2::2) = larger(1)
  end function
end module
