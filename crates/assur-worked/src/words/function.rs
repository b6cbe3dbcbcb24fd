//! Functions of the language in words, for questions on sheets.

use super::{Language, Sentence};

/// What a function gives; {0} and {1} are its arguments.
#[derive(Clone, Copy, Debug)]
pub struct FunctionWords([&'static str; 3]);

impl FunctionWords {
    /// The words of a function of so many arguments, or of a part of what it gives; none where it is better set as a formula.
    #[must_use]
    pub fn of(function: &str, count: usize) -> Option<Self> {
        Some(Self(match function {
            "max" => ["greatest value: {0}", "наибольшее значение: {0}", "最大值：{0}"],
            "min" => ["least value: {0}", "наименьшее значение: {0}", "最小值：{0}"],
            "mean" => ["mean value: {0}", "среднее значение: {0}", "平均值：{0}"],
            "integral" => ["integral: {0}", "интеграл: {0}", "积分：{0}"],
            "argmax" => [
                "position of the drive at the greatest value: {0}",
                "положение привода при наибольшем значении: {0}",
                "取最大值时的驱动位置：{0}",
            ],
            "argmin" => [
                "position of the drive at the least value: {0}",
                "положение привода при наименьшем значении: {0}",
                "取最小值时的驱动位置：{0}",
            ],
            "slope" => ["slope: {0}", "производная: {0}", "斜率：{0}"],
            "work" => ["work of {0}", "работа {0}", "{0} 的功"],
            "friction_work" if count == 0 => ["work of friction", "работа трения", "摩擦力的功"],
            "friction_work" => {
                ["work of friction in {0}", "работа трения в паре {0}", "运动副 {0} 摩擦力的功"]
            }
            "energy" => ["mechanical energy", "механическая энергия", "机械能"],
            "potential_energy" => ["potential energy", "потенциальная энергия", "势能"],
            "pressure_angle" => ["pressure angle of {0}", "угол давления {0}", "{0} 的压力角"],
            "transmission_angle" => ["transmission angle of {0}", "угол передачи {0}", "{0} 的传动角"],
            "curvature_radius" => {
                ["radius of curvature of {0}", "радиус кривизны профиля {0}", "{0} 的曲率半径"]
            }
            "smallest_base_radius" => [
                "smallest base radius of {0} for a pressure angle of at most {1}",
                "наименьший начальный радиус {0} при угле давления не более {1}",
                "压力角不超过 {1} 时 {0} 的最小基圆半径",
            ],
            "start" => [
                "coordinate of the follower of {0} in its lowest position",
                "координата толкателя {0} в нижнем положении",
                "{0} 从动件在最低位置的坐标",
            ],
            "profile" => ["table of the profile of {0}", "таблица профиля {0}", "{0} 的轮廓表"],
            "profile.point" => {
                ["point of the profile of {0} at {1}", "точка профиля {0} при {1}", "{0} 在 {1} 处的轮廓点"]
            }
            "profile.velocity" => {
                ["velocity of the follower of {0}", "скорость толкателя {0}", "{0} 从动件的速度"]
            }
            "profile.acceleration" => {
                ["acceleration of the follower of {0}", "ускорение толкателя {0}", "{0} 从动件的加速度"]
            }
            "tooth_force.Ft" => {
                ["tangential force of the teeth of {0}", "окружная сила в зацеплении {0}", "{0} 的圆周力"]
            }
            "tooth_force.Fr" => {
                ["radial force of the teeth of {0}", "радиальная сила в зацеплении {0}", "{0} 的径向力"]
            }
            "tooth_force.Fn" => {
                ["normal force of the teeth of {0}", "нормальная сила в зацеплении {0}", "{0} 的法向力"]
            }
            "static_substitution.F1" | "dynamic_substitution.F1" => [
                "inertia force of the first mass that stands for {0}",
                "сила инерции первой замещающей массы звена {0}",
                "构件 {0} 第一个代换质量的惯性力",
            ],
            "static_substitution.F2" | "dynamic_substitution.F2" => [
                "inertia force of the second mass that stands for {0}",
                "сила инерции второй замещающей массы звена {0}",
                "构件 {0} 第二个代换质量的惯性力",
            ],
            "dynamic_substitution.a2" => [
                "acceleration of the second mass that stands for {0}",
                "ускорение второй замещающей массы звена {0}",
                "构件 {0} 第二个代换质量的加速度",
            ],
            "table" => ["table of the gears {0}", "таблица зацепления {0}", "{0} 的齿轮参数表"],
            "contact_ratio" => ["contact ratio of {0}", "коэффициент перекрытия {0}", "{0} 的重合度"],
            "wrap" => ["angle of wrap of {0}", "угол обхвата {0}", "{0} 的包角"],
            "capacity" => [
                "greatest load that {0} passes on",
                "наибольшая нагрузка, передаваемая {0}",
                "{0} 能传递的最大载荷",
            ],
            "slips" => ["whether {0} slips", "проскальзывает ли {0}", "{0} 是否打滑"],
            "sticks" => {
                ["whether {0} is held by friction", "удерживается ли {0} трением", "{0} 是否被摩擦力保持"]
            }
            "rests" => ["whether {0} is in contact", "есть ли контакт в {0}", "{0} 是否接触"],
            "count" => ["number of events {0}", "число событий {0}", "事件 {0} 的次数"],
            "distance" => ["distance from {0} to {1}", "расстояние от {0} до {1}", "{0} 到 {1} 的距离"],
            "instant_centre" if count == 1 => {
                ["instant centre of {0}", "мгновенный центр скоростей {0}", "{0} 的速度瞬心"]
            }
            "instant_centre" => [
                "instant centre of {0} and {1}",
                "мгновенный центр вращения {0} и {1}",
                "{0} 与 {1} 的相对速度瞬心",
            ],
            "critical" => [
                "value of {0} at which the mechanism locks itself",
                "значение {0}, при котором наступает самоторможение",
                "发生自锁时 {0} 的值",
            ],
            "contact_force" => [
                "force in {0} at contact point {1}",
                "сила в паре {0} в точке контакта {1}",
                "运动副 {0} 接触点 {1} 处的力",
            ],
            "inertia_arm" => [
                "arm of the resultant inertia force of {0}",
                "плечо равнодействующей сил инерции {0}",
                "{0} 惯性力合力的力臂",
            ],
            "line_offset" => [
                "where the resultant crosses the guide of {0}",
                "где равнодействующая пересекает направляющую {0}",
                "合力与 {0} 导路交点的坐标",
            ],
            "radius" => ["radius of {0}", "радиус {0}", "{0} 的半径"],
            "journal_torque" => ["friction torque of the journal", "момент трения в цапфе", "轴颈的摩擦力矩"],
            "thrust_torque" => {
                ["friction torque of the thrust bearing", "момент трения в пяте", "推力轴承的摩擦力矩"]
            }
            "raising_torque" => ["torque that raises the load", "момент при подъёме груза", "举升载荷的力矩"],
            // their arguments
            "=load" => ["load {0}", "нагрузка {0}", "载荷 {0}"],
            "=radius" => ["radius {0}", "радиус {0}", "半径 {0}"],
            "=outer" => ["outer radius {0}", "наружный радиус {0}", "外半径 {0}"],
            "=inner" => ["inner radius {0}", "внутренний радиус {0}", "内半径 {0}"],
            "=diameter" => ["mean diameter {0}", "средний диаметр {0}", "中径 {0}"],
            "=lead" => ["lead {0}", "ход резьбы {0}", "导程 {0}"],
            "=friction" => ["coefficient of friction {0}", "коэффициент трения {0}", "摩擦因数 {0}"],
            "=flank" => ["flank angle {0}", "угол наклона профиля {0}", "牙侧角 {0}"],
            "fit=even" => ["even pressure", "равномерное давление", "均匀压强"],
            "fit=worn" => ["worn in", "приработанная", "跑合后"],
            "lowering_torque" => {
                ["torque that lowers the load", "момент при опускании груза", "下放载荷的力矩"]
            }
            _ => return None,
        }))
    }
}

impl Sentence for FunctionWords {
    fn template(self, language: Language) -> &'static str {
        let [english, russian, chinese] = self.0;
        match language {
            Language::English => english,
            Language::Russian => russian,
            Language::Chinese => chinese,
        }
    }
}
