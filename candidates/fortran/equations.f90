!> The equations as they are used: the page's, with the corrections of the ledger.
!>
!> Arguments have the names of docs/conformance.md. What is elemental takes one number or an array of them;
!> vectors are the columns of a matrix. Every operation is in the order of the reference.
module equations
   use, intrinsic :: iso_fortran_env, only: wp => real64
   implicit none
   private :: inertia

   !> What (17) and (18) are evaluated with, beside the velocity by (2).
   type :: push_t
      real(wp) :: A = 0, alpha_s = 0           !< s/kg, 1
      real(wp) :: T2_perp = 0, T2_para = 0     !< N
      real(wp) :: cos_phi1_x = 0, cos_phi1_y = 0
      real(wp) :: du = 0, dv = 0               !< what (2) has added, m/s
      real(wp) :: m1 = 0, m2 = 0               !< lumped masses of primary and secondary, kg
   end type push_t

   !> Along the primary and across it: the velocity by (2), and the secondary's share of the moving mass.
   type :: inertia_t
      real(wp) :: along, across, share_along, share_across
   end type inertia_t

contains

   !> Length of each column. (NORM2 and SUM may add in an order of their own.)
   pure function lengths(d) result(length)
      real(wp), intent(in) :: d(:, :)
      real(wp) :: length(size(d, 2))
      integer :: k
      length = d(1, :)*d(1, :)
      do k = 2, size(d, 1)
         length = length + d(k, :)*d(k, :)
      end do
      length = sqrt(length)
   end function lengths

   elemental real(wp) function eqn_1(T_ahead, T_here, v, v_before, m_over_dt)
      real(wp), intent(in) :: T_ahead, T_here, v, v_before, m_over_dt
      eqn_1 = T_ahead - T_here - (v - v_before)*m_over_dt
   end function eqn_1

   elemental real(wp) function eqn_2(v_before, T_ahead, T_here, A)
      real(wp), intent(in) :: v_before, T_ahead, T_here, A
      eqn_2 = v_before + (T_ahead - T_here)*A
   end function eqn_2

   elemental real(wp) function eqn_3(L, L_before)
      real(wp), intent(in) :: L, L_before
      eqn_3 = (L - L_before)/L_before
   end function eqn_3

   elemental real(wp) function eqn_4(strain_before, L, L_before)
      real(wp), intent(in) :: strain_before, L, L_before
      eqn_4 = strain_before + L/L_before - 1
   end function eqn_4

   !> In the place of (4).
   elemental real(wp) function engineering_strain(L, L_0)
      real(wp), intent(in) :: L, L_0
      engineering_strain = L/L_0 - 1
   end function engineering_strain

   pure function eqn_5(x_ahead, x_here) result(L_before)
      real(wp), intent(in) :: x_ahead(:, :), x_here(:, :)
      real(wp) :: L_before(size(x_here, 2))
      L_before = lengths(x_ahead - x_here)
   end function eqn_5

   pure function eqn_6(x_ahead, v_ahead, x_here, v_here, dt) result(L)
      real(wp), intent(in) :: x_ahead(:, :), v_ahead(:, :), x_here(:, :), v_here(:, :), dt
      real(wp) :: L(size(x_here, 2))
      L = lengths((x_ahead + v_ahead*dt) - (x_here + v_here*dt))
   end function eqn_6

   elemental real(wp) function eqn_7(E, strain)
      real(wp), intent(in) :: E, strain
      eqn_7 = E*strain
   end function eqn_7

   elemental real(wp) function eqn_8(v_p_before, T_y, m_p, m_node, dt)
      real(wp), intent(in) :: v_p_before, T_y, m_p, m_node, dt
      eqn_8 = v_p_before - 2*(-T_y)*dt/(m_p + m_node)
   end function eqn_8

   elemental real(wp) function eqn_9(u, v, cos, sin)
      real(wp), intent(in) :: u, v, cos, sin
      eqn_9 = u*cos + v*sin
   end function eqn_9

   elemental real(wp) function eqn_10(u, v, cos, sin)
      real(wp), intent(in) :: u, v, cos, sin
      eqn_10 = v*cos - u*sin
   end function eqn_10

   !> Cosine and sine of theta.
   pure function eqn_11(x_here, y_here, x_behind, y_behind) result(theta)
      real(wp), intent(in) :: x_here, y_here, x_behind, y_behind
      real(wp) :: theta(2), dx, dy
      dx = x_here - x_behind
      dy = y_here - y_behind
      theta = [dx, dy]/sqrt(dx*dx + dy*dy)
   end function eqn_11

   elemental real(wp) function eqn_12(alpha_s, v_para, v_perp, cos, sin)
      real(wp), intent(in) :: alpha_s, v_para, v_perp, cos, sin
      eqn_12 = alpha_s*v_para*cos - v_perp*sin
   end function eqn_12

   elemental real(wp) function eqn_13(alpha_s, v_para, v_perp, cos, sin)
      real(wp), intent(in) :: alpha_s, v_para, v_perp, cos, sin
      eqn_13 = alpha_s*v_para*sin + v_perp*cos
   end function eqn_13

   pure real(wp) function eqn_14()
      eqn_14 = 0
   end function eqn_14

   elemental real(wp) function eqn_15(T2, cos_phi1_x, cos_phi1_y, cos_phi2_x, cos_phi2_y)
      real(wp), intent(in) :: T2, cos_phi1_x, cos_phi1_y, cos_phi2_x, cos_phi2_y
      eqn_15 = T2*(cos_phi2_x*cos_phi1_x + cos_phi2_y*cos_phi1_y)
   end function eqn_15

   elemental real(wp) function eqn_16(T2, cos_phi1_x, cos_phi1_y, cos_phi2_x, cos_phi2_y)
      real(wp), intent(in) :: T2, cos_phi1_x, cos_phi1_y, cos_phi2_x, cos_phi2_y
      eqn_16 = T2*(cos_phi2_y*cos_phi1_x - cos_phi2_x*cos_phi1_y)
   end function eqn_16

   elemental real(wp) function eqn_17(u_by_2, p)
      real(wp), intent(in) :: u_by_2
      type(push_t), intent(in) :: p
      type(inertia_t) :: i
      i = inertia(p)
      eqn_17 = u_by_2 + 2*p%A*(p%T2_perp*(1 - i%share_across)*(-p%cos_phi1_y) &
         + p%alpha_s*p%T2_para*(1 - i%share_along)*p%cos_phi1_x) &
         - (i%share_along*i%along*p%cos_phi1_x - i%share_across*i%across*p%cos_phi1_y)
   end function eqn_17

   elemental real(wp) function eqn_18(v_by_2, p)
      real(wp), intent(in) :: v_by_2
      type(push_t), intent(in) :: p
      type(inertia_t) :: i
      i = inertia(p)
      eqn_18 = v_by_2 + 2*p%A*(p%T2_perp*(1 - i%share_across)*p%cos_phi1_x &
         + p%alpha_s*p%T2_para*(1 - i%share_along)*p%cos_phi1_y) &
         - (i%share_along*i%along*p%cos_phi1_y + i%share_across*i%across*p%cos_phi1_x)
   end function eqn_18

   elemental type(inertia_t) function inertia(p)
      type(push_t), intent(in) :: p
      real(wp) :: m2_along
      m2_along = p%alpha_s*p%alpha_s*p%m2
      inertia%along = p%du*p%cos_phi1_x + p%dv*p%cos_phi1_y
      inertia%across = p%dv*p%cos_phi1_x - p%du*p%cos_phi1_y
      inertia%share_along = m2_along/(p%m1 + m2_along)
      inertia%share_across = p%m2/(p%m1 + p%m2)
   end function inertia

   elemental real(wp) function eqn_19(c, curvature)
      real(wp), intent(in) :: c, curvature
      eqn_19 = c*c*curvature
   end function eqn_19

   elemental real(wp) function eqn_20(c, dt, dx)
      real(wp), intent(in) :: c, dt, dx
      eqn_20 = c*(dt/dx)
   end function eqn_20

end module equations
