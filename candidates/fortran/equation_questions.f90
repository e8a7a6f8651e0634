!> A question about an equation: its number and its inputs by name.
module equation_questions
   use equations
   use json
   implicit none
   private
   public :: evaluate

contains

   !> What comes of an equation: one number, the components of a vector, or nothing where the page has no
   !> such equation. Clears `good` where an input is missing.
   subroutine evaluate(question, eq, inputs, engineering, out, good)
      type(json_t), intent(in) :: question
      integer, intent(in) :: eq, inputs
      logical, intent(in) :: engineering
      real(wp), allocatable, intent(out) :: out(:)
      logical, intent(inout) :: good
      integer :: d, number

      d = 2 ! dimensions
      if (vectors_are_in_space('T_ahead') .or. vectors_are_in_space('x_ahead')) d = 3
      do number = 1, 20
         if (question%is(eq, name_of(number))) exit
      end do
      select case (number)
      case (1)
         out = eqn_1(vector('T_ahead'), vector('T_here'), vector('v'), vector('v_before'), x('m_over_dt'))
      case (2)
         out = eqn_2(vector('v_before'), vector('T_ahead'), vector('T_here'), x('A'))
      case (3)
         out = [eqn_3(x('L'), x('L_before'))]
      case (4)
         if (engineering) then
            out = [engineering_strain(x('L'), x('L_0'))]
         else
            out = [eqn_4(x('strain_before'), x('L'), x('L_before'))]
         end if
      case (5)
         out = eqn_5(column('x_ahead'), column('x_here'))
      case (6)
         out = eqn_6(column('x_ahead'), column('v_ahead'), column('x_here'), column('v_here'), x('dt'))
      case (7)
         out = [eqn_7(x('E'), x('strain'))]
      case (8)
         out = [eqn_8(x('v_p_before'), x('T_y'), x('m_p'), x('m_node'), x('dt'))]
      case (9)
         out = [eqn_9(x('u'), x('v'), x('cos'), x('sin'))]
      case (10)
         out = [eqn_10(x('u'), x('v'), x('cos'), x('sin'))]
      case (11)
         out = eqn_11(x('x_here'), x('y_here'), x('x_behind'), x('y_behind'))
      case (12)
         out = [eqn_12(x('alpha_s'), x('v_para'), x('v_perp'), x('cos'), x('sin'))]
      case (13)
         out = [eqn_13(x('alpha_s'), x('v_para'), x('v_perp'), x('cos'), x('sin'))]
      case (14)
         out = [eqn_14()]
      case (15)
         out = [eqn_15(x('T2'), x('cos_phi1_x'), x('cos_phi1_y'), x('cos_phi2_x'), x('cos_phi2_y'))]
      case (16)
         out = [eqn_16(x('T2'), x('cos_phi1_x'), x('cos_phi1_y'), x('cos_phi2_x'), x('cos_phi2_y'))]
      case (17)
         out = [eqn_17(x('u_by_2'), push())]
      case (18)
         out = [eqn_18(x('v_by_2'), push())]
      case (19)
         out = [eqn_19(x('c'), x('curvature'))]
      case (20)
         out = [eqn_20(x('c'), x('dt'), x('dx'))]
      case default
         allocate (out(0))
      end select

   contains

      logical function vectors_are_in_space(name)
         character(*), intent(in) :: name
         vectors_are_in_space = question%items(question%member(inputs, name), 3) /= none
      end function vectors_are_in_space

      real(wp) function x(name)
         character(*), intent(in) :: name
         x = question%number(question%member(inputs, name), good)
      end function x

      function vector(name) result(v)
         character(*), intent(in) :: name
         real(wp) :: v(d)
         v = question%all_numbers(question%member(inputs, name), d, good)
      end function vector

      function column(name) result(v)
         character(*), intent(in) :: name
         real(wp) :: v(d, 1)
         v(:, 1) = vector(name)
      end function column

      type(push_t) function push()
         push = push_t(A=x('A'), alpha_s=x('alpha_s'), T2_perp=x('T2_perp'), T2_para=x('T2_para'), &
                       cos_phi1_x=x('cos_phi1_x'), cos_phi1_y=x('cos_phi1_y'), &
                       du=x('du'), dv=x('dv'), m1=x('m1'), m2=x('m2'))
      end function push

   end subroutine evaluate

   pure function name_of(number) result(name)
      integer, intent(in) :: number
      character(:), allocatable :: name
      character(2) :: digits
      write (digits, '(i0)') number
      name = trim(digits)
   end function name_of

end module equation_questions
