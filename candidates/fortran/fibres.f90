!> Two crossed fibres, one of them struck by a projectile: a step and a run.
!>
!> A fibre has nodes 0..n from the impact point (the secondary: from the crossover) to its clamp; element i
!> lies between the nodes i-1 and i. Vectors are columns: two components on the primary, three on the secondary.
module fibres
   use, intrinsic :: ieee_arithmetic, only: ieee_is_finite
   use, intrinsic :: iso_fortran_env, only: int64
   use equations
   implicit none
   private
   public :: fibre_t, system_t, fibre, with_time_step, at_impact, step, run
   public :: completed, diverged, crossover_left

   integer, parameter :: completed = 1, diverged = 2, crossover_left = 3

   type :: fibre_t
      integer :: n = 0                                          !< elements
      real(wp) :: spacing = 0, mass = 0, stiffness = 0          !< m, kg, modulus x area in N
      real(wp) :: crossing_time = 0, a = 0                      !< spacing / wave speed, s; dt/dm, s/kg
      real(wp), allocatable :: x(:, :), v(:, :)                 !< m, m/s
      real(wp), allocatable :: strain(:), tension(:), unstrained(:) !< 1, N, m
   end type fibre_t

   type :: system_t
      type(fibre_t) :: primary, secondary
      logical :: crossed = .false., engineering = .false., has_mass = .false.
      real(wp) :: at = 0, alpha_s = 0                           !< m, 1
      real(wp) :: impact_velocity = 0, projectile_mass = 0      !< m/s, kg
      real(wp) :: dt = 0
      integer(int64) :: steps = 0                               !< in the whole run
      ! What a step changes, beside the fibres:
      integer(int64) :: step = 0, moves = 0
      integer :: ix = 0
      real(wp) :: v_p = 0                                       !< of the projectile in the next step, m/s
   end type system_t

contains

   !> All but the time step and the place.
   pure type(fibre_t) function fibre(length, n, density, area, modulus)
      real(wp), intent(in) :: length, density, area, modulus
      integer, intent(in) :: n
      fibre%n = n
      fibre%spacing = length/n
      fibre%mass = density*area*fibre%spacing
      fibre%stiffness = modulus*area
      fibre%crossing_time = fibre%spacing/sqrt(modulus/density)
   end function fibre

   pure subroutine with_time_step(f, dt)
      type(fibre_t), intent(inout) :: f
      real(wp), intent(in) :: dt
      f%a = dt/f%mass
   end subroutine with_time_step

   !> At rest from `start` along an axis.
   pure subroutine lay(f, start, axis)
      type(fibre_t), intent(inout) :: f
      real(wp), intent(in) :: start(:)
      integer, intent(in) :: axis
      integer :: i
      f%x = spread(start, 2, f%n + 1)
      f%x(axis, :) = f%x(axis, :) + [(i*f%spacing, i=0, f%n)]
      call number_from_zero(f%x)
      f%v = 0*f%x
      call number_from_zero(f%v)
      f%unstrained = lengths(f%x(:, 1:f%n) - f%x(:, 0:f%n - 1))
      f%strain = 0*f%unstrained
      f%tension = 0*f%unstrained
   end subroutine lay

   !> The second index begins at 0, as nodes do.
   pure subroutine number_from_zero(x)
      real(wp), allocatable, intent(inout) :: x(:, :)
      real(wp), allocatable :: from_zero(:, :)
      allocate (from_zero(size(x, 1), 0:size(x, 2) - 1), source=x)
      call move_alloc(from_zero, x)
   end subroutine number_from_zero

   !> The system as it is at impact.
   pure subroutine at_impact(s)
      type(system_t), intent(inout) :: s
      s%step = 0
      s%moves = 0
      s%v_p = s%impact_velocity
      call lay(s%primary, [0.0_wp, 0.0_wp], 1)
      if (.not. s%crossed) return
      call lay(s%secondary, [s%at, 0.0_wp, 0.0_wp], 3)
      s%ix = minloc(abs(s%primary%x(1, :) - s%at), dim=1) - 1 ! the first of equals
   end subroutine at_impact

   !> The tension of each element as a vector: "the same direction as the element itself".
   pure function pull(f) result(T)
      type(fibre_t), intent(in) :: f
      real(wp) :: T(size(f%x, 1), f%n)
      real(wp) :: per_length(f%n)
      T = f%x(:, 1:f%n) - f%x(:, 0:f%n - 1)
      per_length = f%tension/lengths(T)
      T = T*spread(per_length, 1, size(T, 1))
   end function pull

   !> One fibre from t-1 to t; `driven` is the velocity of its first node.
   !>
   !> The page goes from element to element. All that an element needs is of t-1 or a velocity of t, so
   !> that whole arrays give the same; ahead of the wavefront every operation gives zero.
   subroutine march(f, dt, engineering, driven, ix, push)
      type(fibre_t), intent(inout) :: f
      real(wp), intent(in) :: dt, driven(:)
      logical, intent(in) :: engineering
      integer, intent(in), optional :: ix
      type(push_t), intent(in), optional :: push
      real(wp) :: T(size(driven), f%n), L_before(f%n), L(f%n)

      associate (n => f%n, x => f%x, v => f%v)
         T = pull(f)
         v(:, 0) = driven
         v(:, 1:n - 1) = eqn_2(v(:, 1:n - 1), T(:, 2:n), T(:, 1:n - 1), f%a)
         if (present(push)) then
            v(1, ix) = eqn_17(v(1, ix), push)
            v(2, ix) = eqn_18(v(2, ix), push)
         end if
         L = eqn_6(x(:, 1:n), v(:, 1:n), x(:, 0:n - 1), v(:, 0:n - 1), dt)
         if (engineering) then
            f%strain = engineering_strain(L, f%unstrained)
         else
            L_before = eqn_5(x(:, 1:n), x(:, 0:n - 1))
            f%strain = eqn_4(f%strain, L, L_before)
         end if
         f%tension = eqn_7(f%stiffness, f%strain)
         x = x + v*dt
      end associate
   end subroutine march

   !> (15), (16) and what (17) and (18) need: tensions and directions are of t-1.
   function push_of(s) result(push)
      type(system_t), intent(in) :: s
      type(push_t) :: push
      real(wp) :: phi1(2), phi2(3), T(2, s%primary%n), length(1)
      associate (x1 => s%primary%x, x2 => s%secondary%x, ix => s%ix, T2 => s%secondary%tension(1))
         T = pull(s%primary)
         length = eqn_5(x1(:, ix:ix), x1(:, ix - 1:ix - 1))
         phi1 = (x1(:, ix) - x1(:, ix - 1))/length(1)
         length = eqn_5(x2(:, 1:1), x2(:, 0:0))
         phi2 = (x2(:, 1) - x2(:, 0))/length(1)
         push%A = s%primary%a
         push%alpha_s = s%alpha_s
         push%T2_para = eqn_15(T2, phi1(1), phi1(2), phi2(1), phi2(2))
         push%T2_perp = eqn_16(T2, phi1(1), phi1(2), phi2(1), phi2(2))
         push%cos_phi1_x = phi1(1)
         push%cos_phi1_y = phi1(2)
         push%du = (T(1, ix + 1) - T(1, ix))*push%A ! the element ahead of node ix is ix+1
         push%dv = (T(2, ix + 1) - T(2, ix))*push%A
         push%m1 = s%primary%mass
         push%m2 = s%secondary%mass
      end associate
   end function push_of

   !> (9)-(14): the velocity that the primary's node imposes on the secondary's first.
   pure function drive(s) result(v)
      type(system_t), intent(in) :: s
      real(wp) :: v(3), theta(2), v_para, v_perp
      associate (here => s%primary%x(:, s%ix), behind => s%primary%x(:, s%ix - 1), &
                 at => s%primary%v(:, s%ix))
         theta = eqn_11(here(1), here(2), behind(1), behind(2))
         v_para = eqn_9(at(1), at(2), theta(1), theta(2))
         v_perp = eqn_10(at(1), at(2), theta(1), theta(2))
      end associate
      v = [eqn_12(s%alpha_s, v_para, v_perp, theta(1), theta(2)), &
           eqn_13(s%alpha_s, v_para, v_perp, theta(1), theta(2)), eqn_14()]
   end function drive

   !> Node of the primary nearest to the secondary's first, the lower of two equals. There is nothing to look
   !> for where nothing slides, nor before the wave has come to the crossover.
   pure integer function nearest_node(s)
      type(system_t), intent(in) :: s
      real(wp) :: square(0:s%primary%n)
      nearest_node = s%ix
      if (s%alpha_s == 1) return
      if (any(s%primary%tension(:s%ix - 1) == 0)) return
      associate (x => s%primary%x, first => s%secondary%x(:, 0))
         square = (x(1, :) - first(1))**2 + (x(2, :) - first(2))**2 + first(3)**2
      end associate
      nearest_node = minloc(square, dim=1) - 1
   end function nearest_node

   !> (8), with the tensions of all fibres that are struck.
   subroutine brake_projectile(s)
      type(system_t), intent(inout) :: s
      real(wp) :: T(2, s%primary%n), T2(3, s%secondary%n), T_y, m_node
      if (.not. s%has_mass) return
      T = pull(s%primary)
      T_y = T(2, 1)
      m_node = s%primary%mass
      if (s%crossed .and. s%ix == 0) then
         T2 = pull(s%secondary)
         T_y = T_y + T2(2, 1)
         m_node = m_node + s%secondary%mass
      end if
      s%v_p = eqn_8(s%v_p, T_y, s%projectile_mass, m_node, s%dt)
   end subroutine brake_projectile

   logical function is_finite(f)
      type(fibre_t), intent(in) :: f
      is_finite = all(ieee_is_finite(pull(f)))
   end function is_finite

   !> One time step, in the paper's order. After `diverged` the system is amid the step.
   integer function step(s) result(outcome)
      type(system_t), intent(inout) :: s
      real(wp) :: struck(2)
      integer :: nearest

      outcome = completed
      s%step = s%step + 1
      struck = [0.0_wp, 1.0_wp]*s%v_p
      if (s%crossed .and. s%ix > 0) then
         call march(s%primary, s%dt, s%engineering, struck, s%ix, push_of(s))
         call brake_projectile(s)
         call march(s%secondary, s%dt, s%engineering, drive(s))
      else ! what the projectile strikes it drives, one fibre or both
         call march(s%primary, s%dt, s%engineering, struck)
         if (s%crossed) call march(s%secondary, s%dt, s%engineering, [struck, eqn_14()])
         call brake_projectile(s)
      end if
      if (.not. (is_finite(s%primary) .and. ieee_is_finite(s%v_p))) outcome = diverged
      if (.not. s%crossed) return
      if (.not. is_finite(s%secondary)) outcome = diverged
      if (outcome == diverged .or. s%ix == 0) return
      nearest = nearest_node(s)
      if (nearest == 0 .or. nearest == s%primary%n) then
         outcome = crossover_left
      else if (nearest /= s%ix) then
         s%ix = nearest
         s%moves = s%moves + 1
      end if
   end function step

   !> From impact to the end of the scene. What has diverged stands as before that step.
   integer function run(s) result(outcome)
      type(system_t), intent(inout) :: s
      integer :: again
      outcome = run_steps(s, s%steps)
      if (outcome == diverged) again = run_steps(s, s%step - 1) ! costs less than a copy in every step
   end function run

   integer function run_steps(s, steps) result(outcome)
      type(system_t), intent(inout) :: s
      integer(int64), intent(in) :: steps
      call at_impact(s)
      outcome = completed
      do while (outcome == completed .and. s%step < steps)
         outcome = step(s)
      end do
   end function run_steps

end module fibres
