; The words of statements stand in the grammar; functions and properties are names to it.

(comment) @comment
(string) @string
(row_name) @string.special
(number) @number
(unit) @type.builtin
(pose_name) @label

[
  "mech" "mechanism" "given" "let" "gravity" "ground" "link" "shaft" "slider" "spring" "all" "group" "drive" "pose" "assemble"
  "force" "torque" "balance" "cam" "brake" "flywheel" "counterweight" "start" "simulate" "event" "until" "stop" "ignore" "find" "expect" "curve"
  "variants"
] @keyword
(kind) @keyword

[
  "line" "circle" "profile" "mass" "weight" "inertia" "plane" "wheel" "turning" "follower" "lift" "rise" "dwell" "fall" "on" "in" "at"
  "of" "from" "to" "through" "along" "about" "as" "for" "against" "motion" "when" "within" "accelerating" "moving" "near" "phase"
  "steps" "step" "centre" "radius" "diameter" "teeth" "module" "ahead" "behind" "over" "under" "forward" "back" "steady" "cycle"
  "turn" "turns" "rising" "falling" "linear" "smooth" "periodic" "held" "rod" "disc" "ring" "sphere" "plate" "inner" "thickness" "section"
] @keyword.modifier
["and" "or" "not"] @keyword.operator
[(side) (heading) (turn) (law)] @constant.builtin

(property name: _ @property)
(named_argument name: (identifier) @variable.parameter)

(call function: (identifier) @function.call)
((call function: (identifier) @function.builtin)
  ; words: functions
  (#any-of? @function.builtin "sqrt" "abs" "sin" "cos" "tan" "asin" "acos" "atan" "atan2" "exp" "log" "mag" "dot" "cross" "unit" "dir" "max" "min" "slope" "position" "velocity" "acceleration" "jerk" "distance" "instant_centre" "angle" "omega" "alpha" "angular_jerk" "displacement" "relative_velocity" "relative_acceleration" "coriolis" "slip_speed" "travel" "stroke" "time_ratio" "dead" "transmission_angle" "pressure_angle" "reaction" "moment" "axial" "internal" "normal" "friction" "contact_force" "line_offset" "inertia_force" "inertia_torque" "inertia_arm" "shaking_force" "shaking_moment" "rocking_couple" "mass" "mass_centre" "inertia" "static_substitution" "dynamic_substitution" "effort" "power" "speed" "efficiency" "stable" "natural_frequency" "damping_ratio" "damped_frequency" "locked" "critical" "profile" "curvature_radius" "curvature_centre" "start" "smallest_base_radius" "table" "tooth_force" "sliding_velocity" "contact_ratio" "time" "drive" "count" "kinetic_energy" "potential_energy" "energy" "period" "sticks" "rests" "impulse" "fluctuation" "rim" "work" "friction_work" "reduced_torque" "reduced_inertia" "radius" "tangential_force" "normal_force" "tension" "tight_side" "slack_side" "wrap" "capacity" "slips" "frictionless" "mean" "integral" "fourier" "argmax" "argmin" "journal_torque" "thrust_torque" "belt_ratio" "raising_torque" "lowering_torque"))
((name) @constant.builtin
  ; words: collections
  (#any-of? @constant.builtin "reactions" "powers" "axial" "positions" "velocities" "accelerations"))
((name) @constant.builtin (#eq? @constant.builtin "pi"))
(property ((name) @constant.builtin
  ; words: values of properties
  (#any-of? @constant.builtin "ccw" "cw" "even" "far" "line" "round" "worn")))

(link name: (identifier) @type)
(shaft name: (identifier) @type)
(slider name: (identifier) @type)
(pair name: (identifier) @label)
(spring name: (identifier) @label)
(event name: (identifier) @label)
(group name: (identifier) @label)
(counterweight name: (identifier) @type)
(cam name: (identifier) @type)
(curve name: (identifier) @function)
(given name: (identifier) @variable)
(let name: (identifier) @variable)
(load name: (identifier) @variable)
(balance name: (identifier) @variable)
(answer name: (identifier) @variable)
(point name: (identifier) @variable.member)
(line name: (identifier) @variable.member)
(circle name: (identifier) @variable.member)
(path part: (identifier) @variable.member)
(member_of part: (identifier) @variable.member)

["=" "+" "-" "−" "–" "*" "/" "·" "⋅" "^" "@" ".." "<" "<=" ">" ">="] @operator
["(" ")" "[" "]" "{" "}"] @punctuation.bracket
["," ";" ":" "."] @punctuation.delimiter
