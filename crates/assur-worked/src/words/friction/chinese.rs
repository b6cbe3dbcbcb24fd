//! Chinese.

use super::FrictionMessage as Message;

pub(super) const fn template(message: Message) -> &'static str {
    match message {
        Message::FrictionFirst => "将这些摩擦值作为已知载荷，平衡方程为线性：",
        Message::FrictionLaws => "把求得的反力代入摩擦定律，得到相同的摩擦：",
        Message::PairStill => "运动副 {0} 中没有相对滑动，无摩擦。",
        Message::PairHeld => "摩擦使运动副 {0} 保持静止：{1} 与各加速度一起求出，使其两构件没有相对运动。",
        Message::PairHeldByBalance => "摩擦使运动副 {0} 保持静止；{1} 由平衡求得。",
        Message::ContactPoint => "{0} 为运动副 {1} 两构件的接触点。",
        Message::RestsOnStop => "运动副 {0} 靠在挡块上，挡块沿其坐标以 {1} 作用。",
        Message::HoldTurn => "构件 {0}：此自由坐标上没有驱动，故对 {1} 取矩求得 {2}：",
        Message::HoldShift => "构件 {0}：此自由坐标上没有驱动，故沿导路的平衡求得 {1}：",
        Message::FrictionDirect => "该运动副中的压力只取决于载荷，与其摩擦无关。摩擦的方向：",
        Message::FrictionSenses => "本杆组各运动副中的摩擦与相对运动方向相反：",
        Message::PairMovesPositive => {
            "运动副 {0}：构件 {1} 相对构件 {2} 的 {3} > 0，因此作用在构件 {1} 上的 {4} 为负。"
        }
        Message::PairMovesNegative => {
            "运动副 {0}：构件 {1} 相对构件 {2} 的 {3} < 0，因此作用在构件 {1} 上的 {4} 为正。"
        }
        Message::PairBeginsPositive => {
            "运动副 {0} 开始滑动：构件 {1} 的相对加速度为正，故构件 {1} 上的 {2} 为负。"
        }
        Message::PairBeginsNegative => {
            "运动副 {0} 开始滑动：构件 {1} 的相对加速度为负，故构件 {1} 上的 {2} 为正。"
        }
        Message::PairOnGroundPositive => {
            "运动副 {0}：构件 {1} 相对机架的 {2} > 0，因此作用在构件 {1} 上的 {3} 为负。"
        }
        Message::PairOnGroundNegative => {
            "运动副 {0}：构件 {1} 相对机架的 {2} < 0，因此作用在构件 {1} 上的 {3} 为正。"
        }
        Message::FrictionSteps => {
            "第 0 步为无摩擦时的约束反力。以后每一步令各力的作用线平行于上一步的作用线并与摩擦圆相切（移动副取受压一侧），平衡方程成为线性，重新求出反力。最后一列为反力的最大变化与最大反力之比："
        }
        Message::FrictionSearched => {
            "单个杆组的迭代得不到可能的运动；于是对所有运动副的受压侧组合联立求解，下面是所得的解。"
        }
        Message::Change => "变化",
        Message::Losses => "损失与效率",
        Message::PairsLose => "每个运动副损失其摩擦的功率：",
        Message::WithoutFriction => "无摩擦时（下标 0），载荷与平衡力的功率之和为零：",
        Message::EffortsDrive => "平衡力（矩）为驱动力：效率为无摩擦功率与有摩擦功率之比。",
        Message::EffortsResist => "平衡力（矩）为阻力：效率为有摩擦功率与无摩擦功率之比。",
        Message::NotLocked => "η > 0：机构能沿此方向运动，不自锁。",
        Message::LocksItself => "η ≤ 0：仅靠载荷机构不能沿此方向运动（自锁），须由外力帮助。",
        Message::OnlyFriction => "无摩擦时无需外力：外力只用来克服摩擦，效率为 0。",
        Message::LocksFrom => "自锁的临界值：{0} = {1}。",
        Message::Locked => {
            "在此摩擦下任何有限的力都不能使机构运动：平衡与摩擦定律对此运动方向无解。机构自锁，效率为 0。"
        }
        Message::FrictionShares => {
            "摩擦在多于必要数目的运动副中使机构保持静止：各运动副如何分担载荷不能确定，反力也不能确定。"
        }
        Message::FrictionSharesHere => {
            "摩擦在多于所需的运动副中保持这些构件静止。各副如何分担载荷不确定，此处的反力也不确定。"
        }
    }
}
