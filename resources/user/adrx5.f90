! ADRX5 for Adore: radius of the rolling elements. This example gives rollers a crown. The first number of record 12.1
! is the length of the straight land [m], the second the radius of the crown beyond it [m]. Balls are not changed.
module surface_of_elements
  use adore_user
  implicit none
  real(c_double), save :: crown(2)
contains
  integer(c_int32_t) function adrx5(a) bind(c)
    type(adore_surface), intent(inout) :: a
    type(adore_bearing), pointer :: bearing
    real(c_double), pointer :: axial(:), radius(:)
    adrx5 = 0
    if (a%call%mode == ADORE_READ) then
      a%call%active = 1
      if (adore_numbers(a%call, crown) /= 2) then
        call adore_fail(a%call, 'record 12 must contain the length of the land and the crown radius')
        adrx5 = 2
      end if
    end if
    if (a%call%mode /= ADORE_COMPUTE) return
    call c_f_pointer(a%call%bearing, bearing)
    if (bearing%rollers == 0) return
    call c_f_pointer(a%axial, axial, [a%n])
    call c_f_pointer(a%radius, radius, [a%n])
    where (abs(axial) > crown(1)/2) radius = -drop(abs(axial) - crown(1)/2)
  end function
  elemental real(c_double) function drop(e)
    real(c_double), intent(in) :: e
    drop = e*e/(crown(2) + sqrt(max(crown(2)**2 - e*e, 0d0)))
  end function
end module
