//! Chinese.

use super::RunMessage as Message;

pub(super) const fn template(message: Message) -> &'static str {
    match message {
        Message::Run => "载荷作用下的运动",
        Message::EnergyHere => "此刻的动能 Σ ½ m v² + ½ J ω²：",
        Message::Reduced => {
            "等效到自由坐标（下标 r）：等效质量（惯量）具有全部动能，等效力（矩）具有全部载荷的功率："
        }
        Message::ReducedMotion => {
            "等效力（矩）使等效质量（惯量）加速；余下部分（下标 Δ）为等效质量（惯量）沿坐标变化率之半乘以速度平方："
        }
        Message::EnergyOfRun => "整个过程动能的变化等于全部载荷、重力和弹簧所作的功 W（Δ 为余量）：",
        Message::EventsOfRun => "过程中的事件：",
        Message::Event => "事件",
        Message::Instants => "时刻，s",
        Message::RunMethod => "运动方程用 {0} 积分，共 {1} 步（求值 {2} 次）；估计误差为同类最大值的 {3}。",
        Message::ByEnergy => "能量积分法",
        Message::ReducedSeveral => {
            "只让一个自由坐标以单位速度运动而其余静止时，质心和构件的速度（k，逗号后为该坐标）给出等效质量："
        }
        Message::EnergyReduced => "由此得到同样的动能：",
    }
}
