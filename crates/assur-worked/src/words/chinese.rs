//! Chinese.

use super::Message;
use crate::document::Labels;

pub(super) const LABELS: Labels =
    Labels { contents: "目录", figure: "图", rows: ["方程", "大小", "方向"] };

#[allow(clippy::too_many_lines, reason = "a table: one line per message")]
pub(super) const fn template(message: Message) -> &'static str {
    match message {
        Message::Structure => "结构分析",
        Message::Positions => "位置分析",
        Message::Velocities => "速度分析",
        Message::Accelerations => "加速度分析",
        Message::Inertia => "载荷与惯性力",
        Message::Reactions => "运动副反力",
        Message::Check => "校核",
        Message::Results => "结果",
        Message::Given => "已知",
        Message::Value => "数值",
        Message::Quantity => "物理量",
        Message::Letters => "符号",
        Message::Unit => "单位",
        Message::Pair => "运动副",
        Message::Links => "构件",
        Message::Kind => "类型",
        Message::Class => "级别",
        Message::Group => "杆组",
        Message::OuterPairs => "外副",
        Message::InnerPairs => "内副",
        Message::Revolute => "转动副",
        Message::Prismatic => "移动副",
        Message::Slot => "销槽副",
        Message::Contact => "接触副",
        Message::Cylinder => "液压缸",
        Message::Transmission => "传动",
        Message::Lower => "低副",
        Message::Higher => "高副",
        Message::Driven => "原动件",
        Message::Train => "轮系",
        Message::Triad => "三杆组",
        Message::General => "一般杆组",
        Message::DrivenLegs => "带驱动的二级杆组",
        Message::Between => "两导路间的构件",
        Message::SchemeAt => "机构运动简图{0}",
        Message::VelocityPlan => "速度多边形",
        Message::AccelerationPlan => "加速度多边形",
        Message::Freed => "隔离体：{0}",
        Message::Polygon => "力多边形：{0}",
        Message::Lever => "茹可夫斯基杠杆：速度多边形转过 90°，各力作用于其相应点",
        Message::Conventions => "方程中的数值以 m、kg、s、N 和度为单位，逆时针为正。",
        Message::MobilityIs => "机构自由度（n 为活动构件数，其后为低副数和高副数）：",
        Message::Replaced => "高副低代：每个高副用一个构件和两个低副代替：{0}。",
        Message::Passive => "自身转动不影响运动的构件（局部自由度）：{0}。",
        Message::Formula => "结构式：{0}。机构为 {1} 级。运动按此顺序求解，力按相反顺序求解。",
        Message::ForceOrder => "原动件与平衡力不在同一构件上，力的求解顺序为 {0}。",
        Message::GroupOf => "杆组 {0}",
        Message::LinkOf => "构件 {0}",
        Message::DrivenAngle => "由驱动给定 {0}。",
        Message::DrivenRate => "由驱动给定 {0}。",
        Message::SenseOnly => "只给出运动方向：取 {0} 为一个单位，结果与此无关。",
        Message::FreeCoordinate => "载荷作用下的运动给出此时刻的 {0}。",
        Message::Uniform => "原动件匀速运动：{0} = 0。",
        Message::Triangle => "三角形 {0} 的三边已知：",
        Message::LeftOf => "{0} 位于由 {1} 到 {2} 的连线左侧：",
        Message::RightOf => "{0} 位于由 {1} 到 {2} 的连线右侧：",
        Message::Projected => "向 {0} 投影：",
        Message::OnGuide => "{0} 在导路上，由此得构件的方向：",
        Message::AcrossGuide => "垂直于导路投影：",
        Message::AlongGuide => "沿导路投影：",
        Message::Slotted => "{2} 到过 {1} 且沿构件 {0} 导路方向的直线的距离为 {3}（左侧为正）：",
        Message::SlottedThrough => "构件 {0} 的导路平行于 {1}、{2} 的连线：",
        Message::Covered => "{0} 为构件 {1} 上此瞬时与 {2} 重合的点。",
        Message::TwoGuides => "{0} 为沿两导路的轨迹的交点：",
        Message::TwoSlides => "两个叠置的滑块确定 {0} 的位置：",
        Message::BetweenGuides => "构件 {0} 沿两导路滑动，相对导路不转动。",
        Message::Guide => "导路",
        Message::Found => "已求得",
        Message::TurnsCounterClockwise => "构件 {0} 逆时针转动（{1} > 0）。",
        Message::TurnsClockwise => "构件 {0} 顺时针转动（{1} < 0）。",
        Message::DoesNotTurn => "构件 {0} 在此瞬时不转动。",
        Message::MotionStated => "本杆组（{0}）各构件同时封闭，不能逐个求出。求解器得到的位置：",
        Message::AllTogether => {
            "本杆组（{0}）各构件同时封闭，不能逐个求出：{1} 个方程，未知量为各构件原点坐标 x、y 和方向 φ。求解器用牛顿法求解。"
        }
        Message::ThreeLegs => {
            "构件 {0} 的三条支链同时封闭：三个方程，未知量为点 {1}（铰链 {2} 的中点）的坐标和构件方向。求解器用牛顿法求解。"
        }
        Message::NewtonSearched => "迭代从搜索全部装配形式的一个初值开始，各步的最大值：",
        Message::NewtonFollowed => "迭代从运动中稍前的位置开始，{0}，各步的最大值：",
        Message::Step => "步",
        Message::NewtonLeft => "方程余量，m 或 rad",
        Message::NewtonShift => "构件移动，m",
        Message::NewtonTurn => "构件转动，°",
        Message::NewtonMatrix => {
            "第 {0} 步（改变量大于舍入误差的最后一步）的线性方程组，角度以 rad 计。每行为一个方程：对各未知量的导数，右端为余量的相反数："
        }
        Message::NewtonSolution => "其解 δ 修正第 {0} 步后的值（以该步数为下标）：",
        Message::ForcesStated => "本版本只给出该杆组（{0}）的力的结果，不作推导：",
        Message::NotAccurateHere => "该解析式在此位置失去精度，直接给出求解器的值：",
        Message::InertiaArm => "惯性力与惯性力偶合成为一个力 {0}，它到 {1} 的距离为：",
        Message::RestOfLoads => "构件 {0} 上的其他载荷合成到其坐标原点，直接给出：",
        Message::Determinate => "该杆组的平衡方程数等于未知反力数。已知力为其载荷、惯性力和先前求得的反力。",
        Message::TwoForces => "构件 {0} 不受载荷，为二力杆，故 {1} 沿 {2}。",
        Message::MomentsOfLink => "构件 {0}，对 {1} 取矩：",
        Message::PolygonCloses => "作用于杆组的所有力之和为零：",
        Message::InnerPair => "内副 {0} 的反力，由构件 {1} 的平衡求得：",
        Message::SumAlongGuide => "沿导路的力的平衡：",
        Message::SumAcrossGuide => "垂直于导路的力的平衡：",
        Message::SumOfLink => "构件 {0} 的力的平衡：",
        Message::ThroughPoint => "构件 {0} 的其他力都通过 {1}，故 {2} 也通过该点。",
        Message::CoupleOfGuide => "对 {0} 取矩得导路的反力偶 {1}：",
        Message::EachAlongGuide => "各滑块沿自身导路的平衡给出 {0} 处的力：",
        Message::CouplesOpen => "两导路如何分担力偶不能确定，其法向力为：",
        Message::BalanceTurn => "构件 {0}：对 {1} 取矩求得 {2}。",
        Message::BalanceShift => "构件 {0}：沿导路的平衡求得 {1}。",
        Message::ForceAlongLine => "{0} 为正：沿规定的方向作用。",
        Message::ForceAgainstLine => "{0} 为负：与规定的方向相反。",
        Message::NoEffort => "此自由坐标上没有驱动：由运动方程，{0} 为零。",
        Message::ActsCounterClockwise => "{0} 为正：逆时针作用。",
        Message::ActsClockwise => "{0} 为负：顺时针作用。",
        Message::VirtualPower => "所有载荷、惯性力和平衡力的功率之和为零；此式没有用到上面的任何平衡方程：",
        Message::PowerOpen => "此处推导的各项不是功率的全部项，求解器的残差见下。",
        Message::Residuals => {
            "求解器独立方程的残差（相对于最大项）：封闭 {0}，平衡 {1}，功率 {2}。杆组条件数的最小值为 {3}（1 最好）。"
        }
        Message::OpenSizes => "下列各轮的尺寸只给出比值；其中一个取为 1 m，结果与此无关：{0}。",
        Message::SweepStated => "这里详细求解一个位置；其余位置见文末的表格和曲线。",
        Message::TrainPlaces => "轮和轴按传动关系转动；需要时由这些关系求其转角。",
        Message::LawsOfTrain => {
            "每个传动是转速之间的一个线性关系。相对于行星架，啮合的两轮按齿数转动（威利斯公式）。"
        }
        Message::LawsTogether => "其余关系联立求解。其未知量如下，各关系代入这些值（ε 为余量）：",
        Message::Eliminated => "传动 {0} 消去 {1} 后求得 {2}：",
        Message::LawOf => "传动 {0} 求得 {1}：",
        Message::TrainForces => "各轮和轴对其轴线、各滑块沿其导路的平衡，以各传动在轮半径处的力表示：",
        Message::MemberGives => "由 {0} 求得 {1}：",
        Message::MembersGive => "由 {0} 联立，消去 {1}，求得 {2}：",
        Message::SheetHead => "姓名 ______________________   班级 ________   题号 {0}",
        Message::DrawnFor => "简图按第 {0} 题的数据绘制。",
        Message::TextOf => "题文中的数值取自第 {0} 题。",
        Message::OtherPose => "题目要求位置，故简图画在另一位置。",
        Message::Variants => "数据方案",
        Message::Variant => "方案",
        Message::Find => "求",
        Message::Answers => "答案",
        Message::KeyHead => {
            "答案，取四位有效数字。`assur grade` 允许答案偏离其值的 3 %，矢量的分量允许偏离矢量大小的 3 %。逆时针、向右、向上为正。"
        }
        Message::Position => "位置",
        Message::TogetherForces => "各方程代入这些值（余量）：",
        Message::EquilibriumOf => "构件 {0}：",
        Message::Closes => "杆组的每个运动副代入这些值后封闭（Δ 为余量）：",
        Message::AskedFor => "题目所求的点：",
        Message::AskedOfGuides => "题目所求的沿导路的量：",
        Message::AskedOfForces => "题目所求的力、力矩和功率：",
        Message::NothingActs => "此位置构件上没有任何载荷：所有反力和平衡力均为零。",
        Message::NoForces => "题目没有要求力，或力不能确定。",
        Message::SeeScheme => "点和方向见 {0}。",
        Message::SeePlan => "{0} 按比例画出本节的矢量。",
        Message::SeeFreed => "隔离体及其受力见 {0}。",
        Message::SeePolygon => "按比例画出，此式即 {0} 中的封闭力多边形。",
        Message::SeeLever => "{0} 用转过的速度多边形对极点的力矩表示同一平衡。",
        Message::Rates => "驱动没有给出速度，不作速度分析。",
        // friction: iteration, losses
        // loads
        Message::LoadHere => "题目给出 {0} = {1}。在此位置：",
        // guides
        Message::CoupleOnFirst => {
            "全部力偶计入第一导路，两法向力均过 {0}：法向力与此无关，导路的力偶则取决于此。"
        }
        // groups as a whole
        Message::EquationsTogether => {
            "本杆组各构件共有 {0} 个平衡方程、{1} 个未知量，联立求解。每行为一个方程：各未知量的系数，右端为已知项："
        }
        Message::SolutionIs => "解为：",
        // rates of groups as a whole
        Message::RatesTogether => {
            "本杆组各转动副同时封闭，得 {0} 个线性方程。每行为一个方程：各未知量的系数，右端为已知项："
        }
        // trains
        Message::PowerFlows => "功率经 {0} 由 {1} 传至 {2}：{1} 侧的力只有 {3} 倍传到 {2}。",
        Message::TeethPress => "{0} 的轮齿还按压力角产生径向力：",
        Message::BearingsOf => "轴承承受其轮上所有力之和：",
        Message::TrainPowers => "各传动从主动侧取得的功率（相对系杆）及其损失：",
        // Willis
        Message::CarrierLocked => "系杆固定",
        Message::CarrierTurns => "随系杆转动",
        Message::SumOfBoth => "合计",
        Message::WillisParts => "系杆 {0} 上各轮的转速与 {1} 之比（精确分数）：",
        Message::WillisSpeeds => "系杆 {0} 上各轮的转速（rad/s）：",
        // cycle, flywheels, cams, gears
        // sizes
        Message::Sizes => "尺寸",
        Message::SizesOf => "由给定值求得：",
        // cams in motion
        Message::CamTurned => {
            "凸轮 {0} 自其 x 轴指向从动件起已转过 {1}；运动规律给出升程 {2} 及其对凸轮转角的导数（′、″）："
        }
        Message::CamTurnedBy => {
            "凸轮 {0} 处于运动规律给出从动件升程 {2} 的位置；{1} 为自其 x 轴指向从动件起转过的角："
        }
        Message::SplineSlopes => {
            "表中各行处升程对凸轮转角的斜率 σ 联立求解，使二阶导数处处连续：每个斜率由相邻斜率求得。升程 s = s₀ + a u + b u² + c u³："
        }
        Message::RootOfLaw => "{0} 是该段运动规律的根，用牛顿法求得；代入规律如下。",
        Message::CamDwells => "凸轮处于休止段：从动件不动。",
        Message::PlanetsEven => {
            "行星轮 {0} 绕 {1} 的轴线均匀分布：其质心始终在该轴上；{1} 除自身转动惯量外，还有位于行星轴处的行星质量："
        }
        Message::LiftBegins => "升程起点处从动件到凸轮中心的距离为 {0}。",
        Message::HeldByArc => "拨销不在任何槽内，锁止弧将槽轮 {0} 固定在 {1}：",
        Message::TurnsWith => "构件 {0} 相对构件 {1} 不转动。",
        Message::Rests => "构件 {0} 静止。",
        // motions under loads
        // powers
        Message::Powers => "功率",
        // cylinders
        Message::CommonNormal => "{0} 为凸轮与从动件的相对瞬心，公法线通过它和 {1}：",
        Message::StaticMasses => {
            "构件 {0} 用位于 {1} 和 {2} 的两个质量静代换，总质量和质心不变；ΔJ 为转动惯量之差："
        }
        Message::DynamicMasses => {
            "构件 {0} 用位于 {1} 和摆动中心 {2} 的两个质量动代换，总质量、质心和转动惯量不变："
        }
        Message::StiffLink => {
            "在此位置构件 {0} 和 {1} 相当于一个构件。在构件 {0} 的坐标系中，{2} 相对于 {3} 的位置为 ξ、η："
        }
        Message::CylinderLength => "主动件给出液压缸两铰链间的长度 {0}。",
        Message::PlaceOpen => "轴的位置没有给出，故不能确定 {0} 处的反力。",
        Message::CoupleAtSlider => "对滑块上的点 {0}，导路的反力偶为：",
        Message::AskedBesides => "题目还要求的量，由上述结果求得：",
        Message::ByFormulas => "将上述结果代入题目自身的公式：",
        Message::LoadRests => "{0} 在此位置不起作用。",
    }
}
