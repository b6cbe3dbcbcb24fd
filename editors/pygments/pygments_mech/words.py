"""The words of the language, written by `UPDATE=1 cargo test --test repository editors`."""

# words: statements
STATEMENTS = "mech mechanism given let gravity ground link shaft slider spring all group drive pose assemble balance force torque brake cam curve counterweight flywheel find expect variants start equilibrium simulate event until stop ignore".split()
# words: pairs
PAIRS = "revolute prismatic slot contact cylinder mesh rope belt chain rack worm screw clutch weld".split()
# words: members
MEMBERS = "line circle profile mass weight plane inertia wheel".split()
# words: members of cams
CAM_MEMBERS = "turning follower rise dwell fall lift".split()
# words: laws
LAWS = "uniform parabolic harmonic cycloidal poly345 poly4567 modified_trapezoid modified_sine".split()
# words: connecting
CONNECTING = "accelerating against along and as at between ccw cw for from in module moving near not of on or steps through to turning when within".split()
# words: contextual
CONTEXTUAL = "about ahead behind centre diameter forward back cycle falling held left linear right up down step motion over periodic phase radius rising smooth steady teeth turn turns under".split()
# words: functions
FUNCTIONS = "sqrt abs sin cos tan asin acos atan atan2 exp log mag dot cross unit dir max min slope position velocity acceleration jerk distance instant_centre angle omega alpha angular_jerk displacement relative_velocity relative_acceleration coriolis slip_speed travel stroke time_ratio dead transmission_angle pressure_angle reaction moment axial internal normal friction contact_force line_offset inertia_force inertia_torque inertia_arm shaking_force shaking_moment rocking_couple mass mass_centre inertia static_substitution dynamic_substitution effort power speed efficiency stable natural_frequency damping_ratio damped_frequency locked critical profile curvature_radius curvature_centre start smallest_base_radius table tooth_force sliding_velocity contact_ratio time drive count kinetic_energy potential_energy energy period sticks rests impulse fluctuation rim work friction_work reduced_torque reduced_inertia radius tangential_force normal_force tension tight_side slack_side wrap capacity slips frictionless mean integral fourier argmax argmin journal_torque thrust_torque belt_ratio raising_torque lowering_torque".split()
# words: collections
COLLECTIONS = "reactions powers axial positions velocities accelerations".split()
# words: properties
PROPERTIES = "addendum against_cam angle arm base_radius bevel capacity centre_distance clearance cone contacts crossed damping density diameter efficiency equivalent_friction faces fit flank fluctuation free_angle free_length freewheel friction friction_angle friction_circle groove height_to_width inner internal lead load mass offset outer parts phase pivot_distance plane pressure_angle pretension radius ratio restitution rim rolling shift slip slipping slots speed starts static_friction stiffness weight_density with_cam with_links worn wrap".split()
# words: values of properties
VALUES = "ccw cw even far line round worn".split()
# words: units
UNITS = "m mm um µm cm dm km inch ft kg g t lb slug s ms min h rad deg ° gon rev rpm Hz N daN kN MN lbf kgf kp J kJ W kW MW hp PS Pa kPa MPa GPa bar psi %".split()
# words: units after a blank
LAST_UNITS = "mm cm min ms m kg s h rad inch ft".split()
