! ADRX0 for Adore: own material: silicon nitride for elements with material code 2.
module materials
  use adore_user
  implicit none
contains
  integer(c_int32_t) function adrx0(a) bind(c)
    type(adore_adrx0), intent(inout) :: a
    adrx0 = 0
    if (a%call%mode == ADORE_READ) a%call%active = 1
    if (a%call%mode == ADORE_COMPUTE .and. a%part == 0) then
      a%density = 3200
      a%elastic_modulus = 310d9
      a%poisson_ratio = 0.27d0
      a%thermal_expansion = 2.9d-6
    end if
  end function
end module
