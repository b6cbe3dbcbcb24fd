//! What a sheet asks for.

use super::{Language, Sentence};

/// A quantity that is asked for; {0} is the point, link or pair, {1} the link that a force is on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum QuestionMessage {
    Reactions,
    /// A component of {0}.
    AlongX,
    /// A component of {0}.
    AlongY,
    /// {0}, magnitude.
    Magnitude,
    /// {0}, direction.
    Direction,
    /// {0}, without friction.
    Frictionless,
    /// Position of {0}.
    Position,
    /// Velocity of {0}.
    Velocity,
    /// Acceleration of {0}.
    Acceleration,
    /// Angle of link {0}.
    Angle,
    /// Angular velocity of link {0}.
    AngularVelocity,
    /// Angular acceleration of link {0}.
    AngularAcceleration,
    /// Displacement in {0}.
    Displacement,
    /// Relative velocity in {0}.
    RelativeVelocity,
    /// Sliding velocity in {0}.
    Sliding,
    /// Relative acceleration in {0}.
    RelativeAcceleration,
    /// Coriolis acceleration in {0}.
    Coriolis,
    /// Reaction in {0} on link {1}.
    Reaction,
    /// Couple in {0} on link {1}.
    Moment,
    /// Normal force in {0} on link {1}.
    Normal,
    /// Friction in {0} on link {1}.
    Friction,
    /// Power lost by friction in {0}.
    FrictionPower,
    Efficiency,
    /// Whether the mechanism locks itself.
    Locked,
    /// Inertia force of link {0}.
    InertiaForce,
    /// Inertia couple of link {0}.
    InertiaTorque,
    /// Pressure angle in {0}.
    PressureAngle,
    /// Balancing torque {0}.
    BalancingTorque,
    /// Balancing force {0}.
    BalancingEffort,
    /// Effort of the drive {0}.
    DriveEffort,
    /// Load {0}.
    Load,
    /// Power of {0}.
    Power,
    KineticEnergy,
    PotentialEnergy,
    /// Travel in {0}.
    Travel,
    /// Stroke in {0}.
    Stroke,
    /// Ratio of times in {0}.
    TimeRatio,
    /// Tangential force in {0}.
    TangentialForce,
    /// Tooth force in {0}.
    ToothForce,
    /// Pull in {0}.
    Tension,
    /// Pull in the tight side of {0}.
    TightSide,
    /// Pull in the slack side of {0}.
    SlackSide,
    /// Dead position of {0}.
    DeadPosition,
    Period,
    /// Instant of {0}.
    EventTime,
    /// Greatest value: {0}.
    Greatest,
    /// Least value: {0}.
    Least,
    /// Mean value: {0}.
    Mean,
    /// Integral: {0}.
    Integral,
    /// Position of the drive at the greatest value: {0}.
    WhereGreatest,
    /// Work: {0}.
    Work,
    /// Moment of inertia of the flywheel {0}.
    FlywheelInertia,
    /// Fluctuation of energy at {0}.
    Fluctuation,
    /// Width of the rim of {0}.
    RimWidth,
    /// Height of the rim of {0}.
    RimHeight,
    /// Mass of the rim of {0}.
    RimMass,
    /// Torque reduced to the shaft of {0}.
    ReducedTorque,
    /// Moment of inertia reduced to the shaft of {0}.
    ReducedInertia,
    /// Excess work at {0}.
    ExcessWork,
    /// Mass of link {0} replaced at {1}, statically.
    StaticMass,
    /// Mass of link {0} replaced at {1}, dynamically.
    DynamicMass,
    /// Second mass of the dynamic replacement of link {0}.
    SecondMass,
    /// Distance of the second mass of link {0} from the mass centre.
    SecondDistance,
    /// Moment of inertia that the masses of link {0} lack.
    InertiaLeft,
}

impl Sentence for QuestionMessage {
    fn template(self, language: Language) -> &'static str {
        let [english, russian, chinese] = self.templates();
        match language {
            Language::English => english,
            Language::Russian => russian,
            Language::Chinese => chinese,
        }
    }
}

impl QuestionMessage {
    /// English, Russian, Chinese.
    #[allow(clippy::too_many_lines, reason = "a table: one line per message")]
    const fn templates(self) -> [&'static str; 3] {
        match self {
            Self::Reactions => ["all reactions", "все реакции", "所有约束反力"],
            Self::AlongX => ["{0}, x component", "{0}, проекция на ось x", "{0}的 x 分量"],
            Self::AlongY => ["{0}, y component", "{0}, проекция на ось y", "{0}的 y 分量"],
            Self::Magnitude => ["{0}, magnitude", "{0}, модуль", "{0}的大小"],
            Self::Direction => ["{0}, direction", "{0}, направление", "{0}的方向"],
            Self::Frictionless => ["{0}, without friction", "{0}, без трения", "{0}（不计摩擦）"],
            Self::Position => ["position of {0}", "положение точки {0}", "点 {0} 的位置"],
            Self::Velocity => ["velocity of {0}", "скорость точки {0}", "点 {0} 的速度"],
            Self::Acceleration => ["acceleration of {0}", "ускорение точки {0}", "点 {0} 的加速度"],
            Self::Angle => ["angle of link {0}", "угол звена {0}", "构件 {0} 的转角"],
            Self::AngularVelocity => {
                ["angular velocity of link {0}", "угловая скорость звена {0}", "构件 {0} 的角速度"]
            }
            Self::AngularAcceleration => {
                ["angular acceleration of link {0}", "угловое ускорение звена {0}", "构件 {0} 的角加速度"]
            }
            Self::Displacement => ["displacement in {0}", "перемещение в паре {0}", "运动副 {0} 的位移"],
            Self::RelativeVelocity => {
                ["relative velocity in {0}", "относительная скорость в паре {0}", "运动副 {0} 的相对速度"]
            }
            Self::Sliding => {
                ["sliding velocity in {0}", "скорость скольжения в паре {0}", "运动副 {0} 的滑动速度"]
            }
            Self::RelativeAcceleration => [
                "relative acceleration in {0}",
                "относительное ускорение в паре {0}",
                "运动副 {0} 的相对加速度",
            ],
            Self::Coriolis => [
                "Coriolis acceleration in {0}",
                "кориолисово ускорение в паре {0}",
                "运动副 {0} 的科氏加速度",
            ],
            Self::Reaction => [
                "reaction in {0} on link {1}",
                "реакция в паре {0} на звено {1}",
                "运动副 {0} 对构件 {1} 的约束反力",
            ],
            Self::Moment => [
                "couple in {0} on link {1}",
                "момент в паре {0} на звено {1}",
                "运动副 {0} 对构件 {1} 的力偶",
            ],
            Self::Normal => [
                "normal force in {0} on link {1}",
                "нормальная сила в паре {0} на звено {1}",
                "运动副 {0} 对构件 {1} 的法向力",
            ],
            Self::Friction => [
                "friction in {0} on link {1}",
                "трение в паре {0} на звено {1}",
                "运动副 {0} 对构件 {1} 的摩擦力",
            ],
            Self::FrictionPower => {
                ["power lost by friction in {0}", "мощность трения в паре {0}", "运动副 {0} 的摩擦功率"]
            }
            Self::Efficiency => ["efficiency", "КПД", "效率"],
            Self::Locked => ["whether the mechanism locks itself", "есть ли самоторможение", "机构是否自锁"],
            Self::InertiaForce => {
                ["inertia force of link {0}", "сила инерции звена {0}", "构件 {0} 的惯性力"]
            }
            Self::InertiaTorque => {
                ["inertia couple of link {0}", "момент сил инерции звена {0}", "构件 {0} 的惯性力偶矩"]
            }
            Self::PressureAngle => {
                ["pressure angle in {0}", "угол давления в паре {0}", "运动副 {0} 的压力角"]
            }
            Self::BalancingTorque => ["balancing torque {0}", "уравновешивающий момент {0}", "平衡力矩 {0}"],
            Self::BalancingEffort => ["balancing force {0}", "уравновешивающая сила {0}", "平衡力 {0}"],
            Self::DriveEffort => ["effort of the drive {0}", "усилие привода {0}", "驱动 {0} 的驱动力（矩）"],
            Self::Load => ["load {0}", "нагрузка {0}", "载荷 {0}"],
            Self::Power => ["power of {0}", "мощность {0}", "{0} 的功率"],
            Self::KineticEnergy => ["kinetic energy", "кинетическая энергия", "动能"],
            Self::PotentialEnergy => ["potential energy", "потенциальная энергия", "势能"],
            Self::Travel => {
                ["travel in {0}", "ход в паре {0} от крайнего положения", "运动副 {0} 自极限位置的行程"]
            }
            Self::Stroke => ["stroke in {0}", "полный ход в паре {0}", "运动副 {0} 的总行程"],
            Self::TimeRatio => [
                "ratio of times in {0}",
                "коэффициент изменения средней скорости в паре {0}",
                "运动副 {0} 的行程速比系数",
            ],
            Self::TangentialForce => {
                ["tangential force in {0}", "окружная сила в передаче {0}", "传动 {0} 的圆周力"]
            }
            Self::ToothForce => ["tooth force in {0}", "сила в зацеплении {0}", "啮合 {0} 的法向力"],
            Self::Tension => ["pull in {0}", "натяжение {0}", "{0} 的拉力"],
            Self::TightSide => {
                ["pull in the tight side of {0}", "натяжение ведущей ветви {0}", "{0} 的紧边拉力"]
            }
            Self::SlackSide => {
                ["pull in the slack side of {0}", "натяжение ведомой ветви {0}", "{0} 的松边拉力"]
            }
            Self::DeadPosition => {
                ["dead position of {0}", "крайнее положение пары {0}", "运动副 {0} 的极限位置"]
            }
            Self::Period => ["period", "период", "周期"],
            Self::EventTime => ["instant of {0}", "момент события {0}", "事件 {0} 的时刻"],
            Self::Greatest => ["greatest value: {0}", "наибольшее значение: {0}", "最大值：{0}"],
            Self::Least => ["least value: {0}", "наименьшее значение: {0}", "最小值：{0}"],
            Self::Mean => ["mean value: {0}", "среднее значение: {0}", "平均值：{0}"],
            Self::Integral => ["integral: {0}", "интеграл: {0}", "积分：{0}"],
            Self::WhereGreatest => [
                "position of the drive at the greatest value: {0}",
                "положение привода при наибольшем значении: {0}",
                "取最大值时的驱动位置：{0}",
            ],
            Self::Work => ["work: {0}", "работа: {0}", "功：{0}"],
            Self::FlywheelInertia => [
                "moment of inertia of the flywheel {0}",
                "момент инерции маховика {0}",
                "飞轮 {0} 的转动惯量",
            ],
            Self::Fluctuation => {
                ["fluctuation of energy at {0}", "наибольшая избыточная работа {0}", "{0} 的最大盈亏功"]
            }
            Self::RimWidth => ["width of the rim of {0}", "ширина обода {0}", "{0} 轮缘的宽度"],
            Self::RimHeight => ["height of the rim of {0}", "высота обода {0}", "{0} 轮缘的高度"],
            Self::RimMass => ["mass of the rim of {0}", "масса обода {0}", "{0} 轮缘的质量"],
            Self::ReducedTorque => [
                "torque reduced to the shaft of {0}",
                "момент, приведённый к валу {0}",
                "换算到 {0} 轴的等效力矩",
            ],
            Self::ReducedInertia => [
                "moment of inertia reduced to the shaft of {0}",
                "момент инерции, приведённый к валу {0}",
                "换算到 {0} 轴的等效转动惯量",
            ],
            Self::ExcessWork => ["excess work at {0}", "избыточная работа {0}", "{0} 的盈亏功"],
            Self::StaticMass => [
                "mass of link {0} replaced at {1}, statically",
                "масса звена {0}, замещённая в точке {1} статически",
                "构件 {0} 静代换到 {1} 的质量",
            ],
            Self::DynamicMass => [
                "mass of link {0} replaced at {1}, dynamically",
                "масса звена {0}, замещённая в точке {1} динамически",
                "构件 {0} 动代换到 {1} 的质量",
            ],
            Self::SecondMass => [
                "second mass of the dynamic replacement of link {0}",
                "вторая масса динамического замещения звена {0}",
                "构件 {0} 动代换的第二个质量",
            ],
            Self::SecondDistance => [
                "distance of the second mass of link {0} from the mass centre",
                "расстояние второй массы звена {0} от центра масс",
                "构件 {0} 第二个质量到质心的距离",
            ],
            Self::InertiaLeft => [
                "moment of inertia that the masses of link {0} lack",
                "недостающий момент инерции масс звена {0}",
                "构件 {0} 代换质量所缺的转动惯量",
            ],
        }
    }
}
