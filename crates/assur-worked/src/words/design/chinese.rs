//! Chinese.

use super::DesignMessage as Message;

pub(super) const fn template(message: Message) -> &'static str {
    match message {
        Message::CycleOf => "极限位置：{0}",
        Message::ExtremesOf => "{0} 的速度过零处为极限位置，此时主动件位于 φ_1（最小）和 φ_2（最大）：",
        Message::TimesOf => "较长转角与较短转角之比为行程速比系数；θ 为极位夹角：",
        Message::FlywheelOf => "飞轮 {0}（装在 {1} 上）",
        Message::ReducedTorque => "飞轮所要调节的力矩按功率相等换算到其轴上（等效力矩）。在所解位置：",
        Message::FlywheelTable => {
            "M_r 为等效力矩，M_m = {0} 为另一侧的平均力矩；M_r − M_m 所作的盈亏功为 W（自第一位置起）："
        }
        Message::FlywheelExtremes => "在 M_r 等于平均值处，功在 {0}° 最小，在 {1}° 最大：",
        Message::FlywheelInertia => "保证运转不均匀系数 δ 所需的转动惯量：",
        Message::FlywheelRim => "轮缘，质量集中于直径 D，高为宽的 c 倍：",
        Message::CamOf => "凸轮 {0}",
        Message::CamStages => {
            "各阶段的运动规律；Φ 为阶段转角，h 为升程变化，u = φ / Φ 为已转过的比例，s′ 为对凸轮转角的导数。下标为以百分数表示的 u；分段公式者各段均取一处："
        }
        Message::CamDwell => "{0}：停歇。",
        Message::CamOther => "{0}：无简短公式的规律，数值见表。",
        Message::CamRise => "{0}：推程，{1}：",
        Message::CamFall => "{0}：回程，{1}：",
        Message::LawUniform => "等速运动",
        Message::LawParabolic => "等加速等减速运动",
        Message::LawHarmonic => "简谐运动",
        Message::LawCycloidal => "摆线运动",
        Message::LawPoly345 => "3-4-5 次多项式",
        Message::LawPoly4567 => "4-5-6-7 次多项式",
        Message::LawModifiedTrapezoid => "修正梯形（前半段；后半段与之对称）",
        Message::LawModifiedSine => "修正正弦（前半段；后半段与之对称）",
        Message::LawSpline => "样条的一段",
        Message::CamSlopes => {
            "三次样条通过表中各行 i。对凸轮转角的斜率 σ 联立求解，使二阶导数处处连续；每个斜率由相邻斜率求得，各段的系数由两端斜率求得："
        }
        Message::CamStart => "从动件在基圆上的位置：",
        Message::CamPressure => "压力角在凸轮转角 {0}° 处最大；该处（下标 α）：",
        Message::CamCurvature => {
            "理论廓线在凸轮转角 {0}° 处曲率半径最小；该处（下标 ρ），w 为从动点相对凸轮每弧度的路程："
        }
        Message::FaceCurvature => "凸轮转角 {0}° 处实际廓线曲率半径最小；该处（下标 ρ）：",
        Message::FaceLetters => {
            "h 为平底到凸轮中心的距离，h′ 为其对凸轮转角的导数，k 为凸轮每转一弧度平底相对凸轮的转角："
        }
        Message::GearsOf => "齿轮副 {0}",
        Message::InvoluteSolved => "由此渐开线函数得角：",
    }
}
