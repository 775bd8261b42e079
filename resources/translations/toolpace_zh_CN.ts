<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="zh_CN" sourcelanguage="en">
    <context>
        <name>toolpace::ui::SupplyFields</name>
        <message>
            <source>bit/s</source>
            <translation>bit/s</translation>
        </message>
        <message>
            <source>no link</source>
            <translation>无串口</translation>
        </message>
        <message>
            <source>Serial link</source>
            <translation>串口</translation>
        </message>
        <message>
            <source>A block takes</source>
            <translation>每段用时</translation>
        </message>
        <message>
            <source>Bits a second that blocks come at; empty: they are always there</source>
            <translation>程序段到来的速率（比特每秒）；留空：总是已到</translation>
        </message>
        <message>
            <source>What the controller needs to read a block</source>
            <translation>控制器读取一个程序段所需的时间</translation>
        </message>
    </context>
    <context>
        <name>BlockName</name>
        <message>
            <source>line %1</source>
            <translation>第 %1 行</translation>
        </message>
    </context>
    <context>
        <name>Cause</name>
        <message>
            <source>programmed feed</source>
            <translation>编程进给</translation>
        </message>
        <message>
            <source>rapid</source>
            <translation>快移</translation>
        </message>
        <message>
            <source>path speed</source>
            <translation>路径速度</translation>
        </message>
        <message>
            <source>axis speed</source>
            <translation>轴速度</translation>
        </message>
        <message>
            <source>axis acceleration</source>
            <translation>轴加速度</translation>
        </message>
        <message>
            <source>path acceleration</source>
            <translation>路径加速度</translation>
        </message>
        <message>
            <source>jerk</source>
            <translation>加加速度</translation>
        </message>
        <message>
            <source>corner</source>
            <translation>拐角</translation>
        </message>
        <message>
            <source>curvature</source>
            <translation>曲率</translation>
        </message>
        <message>
            <source>look-ahead</source>
            <translation>前瞻</translation>
        </message>
        <message>
            <source>stop</source>
            <translation>停止</translation>
        </message>
        <message>
            <source>dwell</source>
            <translation>暂停</translation>
        </message>
        <message>
            <source>near the pole of the rotary axes</source>
            <translation>靠近旋转轴的奇异点</translation>
        </message>
        <message>
            <source>limit of the program</source>
            <translation>程序设定的限值</translation>
        </message>
    </context>
    <context>
        <name>ColourBy</name>
        <message>
            <source>speed</source>
            <translation>速度</translation>
        </message>
        <message>
            <source>acceleration</source>
            <translation>加速度</translation>
        </message>
        <message>
            <source>jerk</source>
            <translation>加加速度</translation>
        </message>
        <message>
            <source>binding limit</source>
            <translation>限制因素</translation>
        </message>
        <message>
            <source>contour error</source>
            <translation>轮廓误差</translation>
        </message>
    </context>
    <context>
        <name>MouseActions</name>
        <message>
            <source>Mouse</source>
            <translation>鼠标</translation>
        </message>
        <message>
            <source>Go there: program, preview, plots, overview</source>
            <translation>跳转到该处：程序、预览、曲线、总览</translation>
        </message>
        <message>
            <source>click</source>
            <translation>单击</translation>
        </message>
        <message>
            <source>Zoom about the mouse: preview, plots</source>
            <translation>以鼠标为中心缩放：预览、曲线</translation>
        </message>
        <message>
            <source>wheel</source>
            <translation>滚轮</translation>
        </message>
        <message>
            <source>Move the picture, or the time shown</source>
            <translation>移动图像或所示时间段</translation>
        </message>
        <message>
            <source>drag</source>
            <translation>拖动</translation>
        </message>
        <message>
            <source>Turn the preview</source>
            <translation>旋转预览</translation>
        </message>
        <message>
            <source>right drag, or Ctrl and drag</source>
            <translation>右键拖动，或按住 Ctrl 拖动</translation>
        </message>
        <message>
            <source>Show all of it: preview, plots</source>
            <translation>显示全部：预览、曲线</translation>
        </message>
        <message>
            <source>double click</source>
            <translation>双击</translation>
        </message>
        <message>
            <source>Edit a line of the program</source>
            <translation>编辑一行程序</translation>
        </message>
        <message>
            <source>Open a program or a machine</source>
            <translation>打开程序或机床文件</translation>
        </message>
        <message>
            <source>drop a file on the window</source>
            <translation>将文件拖放到窗口</translation>
        </message>
    </context>
    <context>
        <name>MoveUnits</name>
        <message>
            <source>pulse</source>
            <translation>脉冲</translation>
        </message>
        <message>
            <source>cycle</source>
            <translation>周期</translation>
        </message>
    </context>
    <context>
        <name>ParameterNames</name>
        <message>
            <source>Top speed of the path</source>
            <translation>路径最高速度</translation>
        </message>
        <message>
            <source>Acceleration of the path</source>
            <translation>路径加速度</translation>
        </message>
        <message>
            <source>Deceleration of the path</source>
            <translation>路径减速度</translation>
        </message>
        <message>
            <source>Jerk of the path</source>
            <translation>路径加加速度</translation>
        </message>
        <message>
            <source>Jerk, slowing down</source>
            <translation>减速加加速度</translation>
        </message>
        <message>
            <source>Acceleration of the path, most accurate</source>
            <translation>路径加速度（最高精度）</translation>
        </message>
        <message>
            <source>Tolerance</source>
            <translation>公差</translation>
        </message>
        <message>
            <source>Junction deviation</source>
            <translation>拐角偏差</translation>
        </message>
        <message>
            <source>Feed override</source>
            <translation>进给倍率</translation>
        </message>
        <message>
            <source>Speed of %1</source>
            <translation>%1 轴速度</translation>
        </message>
        <message>
            <source>Acceleration of %1</source>
            <translation>%1 轴加速度</translation>
        </message>
        <message>
            <source>Jerk of %1</source>
            <translation>%1 轴加加速度</translation>
        </message>
        <message>
            <source>Travel of %1</source>
            <translation>%1 的行程</translation>
        </message>
        <message>
            <source>Steps of %1</source>
            <translation>%1 的步数</translation>
        </message>
        <message>
            <source>Interpolation period</source>
            <translation>插补周期</translation>
        </message>
        <message>
            <source>Time of a tool change</source>
            <translation>换刀时间</translation>
        </message>
        <message>
            <source>Rapid override</source>
            <translation>快移倍率</translation>
        </message>
        <message>
            <source>Position gain of %1</source>
            <translation>%1 位置增益</translation>
        </message>
        <message>
            <source>Speed feed forward of %1</source>
            <translation>%1 速度前馈</translation>
        </message>
        <message>
            <source>Acceleration feed forward of %1</source>
            <translation>%1 加速度前馈</translation>
        </message>
        <message>
            <source>Bandwidth of %1</source>
            <translation>%1 带宽</translation>
        </message>
        <message>
            <source>Damping of %1</source>
            <translation>%1 阻尼</translation>
        </message>
        <message>
            <source>Backlash of %1</source>
            <translation>%1 反向间隙</translation>
        </message>
        <message>
            <source>Resonance of %1</source>
            <translation>%1 谐振频率</translation>
        </message>
        <message>
            <source>Damping of the resonance of %1</source>
            <translation>%1 谐振阻尼</translation>
        </message>
        <message>
            <source>Acceleration time</source>
            <translation>加速时间</translation>
        </message>
        <message>
            <source>Deceleration time</source>
            <translation>减速时间</translation>
        </message>
    </context>
    <context>
        <name>codes</name>
        <message>
            <source>controller-blends</source>
            <translation>该控制器同时运行两个程序段</translation>
        </message>
        <message>
            <source>controller-refuses</source>
            <translation>控制器拒绝这一步</translation>
        </message>
        <message>
            <source>identify-no-fit</source>
            <translation>驱动模型与测量轨迹不符</translation>
        </message>
        <message>
            <source>tune-no-resonance</source>
            <translation>要限制振动，但机床没有任何轴设有共振频率</translation>
        </message>
        <message>
            <source>identify-still</source>
            <translation>该轴几乎不动，无法辨识</translation>
        </message>
        <message>
            <source>settings-twice</source>
            <translation>该设置出现两次，值不同</translation>
        </message>
        <message>
            <source>settings-classic-jerk</source>
            <translation>采用经典 jerk，未建模</translation>
        </message>
        <message>
            <source>settings-defaulted</source>
            <translation>文件中没有，取控制器的默认值</translation>
        </message>
        <message>
            <source>settings-foreign</source>
            <translation>是别的控制器的设置</translation>
        </message>
        <message>
            <source>settings-kinematics</source>
            <translation>运动学可能另有限制</translation>
        </message>
        <message>
            <source>settings-missing</source>
            <translation>缺少必需的设置</translation>
        </message>
        <message>
            <source>settings-not-known</source>
            <translation>控制器没有这些设置</translation>
        </message>
        <message>
            <source>settings-unknown</source>
            <translation>认不出是哪种控制器的设置</translation>
        </message>
        <message>
            <source>file-changed</source>
            <translation>读取时文件被更改</translation>
        </message>
        <message>
            <source>internal</source>
            <translation>内部错误</translation>
        </message>
        <message>
            <source>out-of-memory</source>
            <translation>内存不足</translation>
        </message>
        <message>
            <source>output-is-input</source>
            <translation>输出文件就是输入文件</translation>
        </message>
        <message>
            <source>output-twice</source>
            <translation>两个输出是同一个文件</translation>
        </message>
        <message>
            <source>sub-program-refused</source>
            <translation>子程序的文件不能用</translation>
        </message>
        <message>
            <source>trace-axes</source>
            <translation>测量轨迹中没有运动的轴</translation>
        </message>
        <message>
            <source>trace-broken</source>
            <translation>测量轨迹文件损坏</translation>
        </message>
        <message>
            <source>trace-columns</source>
            <translation>测量轨迹的列不明</translation>
        </message>
        <message>
            <source>trace-empty</source>
            <translation>测量轨迹文件为空</translation>
        </message>
        <message>
            <source>trace-gap</source>
            <translation>测量轨迹有间断</translation>
        </message>
        <message>
            <source>trace-number</source>
            <translation>测量轨迹中的值不是有限数</translation>
        </message>
        <message>
            <source>trace-other-program</source>
            <translation>测量轨迹属于另一个程序</translation>
        </message>
        <message>
            <source>trace-saturated</source>
            <translation>测量通道饱和</translation>
        </message>
        <message>
            <source>trace-short</source>
            <translation>测量轨迹太短</translation>
        </message>
        <message>
            <source>trace-time</source>
            <translation>测量轨迹的时间有误</translation>
        </message>
        <message>
            <source>trace-unit</source>
            <translation>测量轨迹的单位有误</translation>
        </message>
        <message>
            <source>travel</source>
            <translation>超出行程</translation>
        </message>
        <message>
            <source>extruder-ignored</source>
            <translation>忽略挤出轴 E</translation>
        </message>
        <message>
            <source>g-code-unfollowed</source>
            <translation>此 G 代码未被执行</translation>
        </message>
        <message>
            <source>g96-limit</source>
            <translation>G96 的最高转速 D 无效</translation>
        </message>
        <message>
            <source>motion-too-long</source>
            <translation>运动时间过长</translation>
        </message>
        <message>
            <source>ramp-times</source>
            <translation>加速时间 Tacc 与程序段不相称</translation>
        </message>
        <message>
            <source>sender-command</source>
            <translation>发送器命令不属于程序路径</translation>
        </message>
        <message>
            <source>smooth-fell-back</source>
            <translation>无法平滑，改用拐角过渡</translation>
        </message>
        <message>
            <source>spindle-unbounded</source>
            <translation>恒线速时主轴转速没有上限</translation>
        </message>
        <message>
            <source>text-utf-16</source>
            <translation>文本为 UTF-16 编码，请存为 UTF-8</translation>
        </message>
        <message>
            <source>no-feed</source>
            <translation>没有进给速度 F</translation>
        </message>
        <message>
            <source>feed-zero</source>
            <translation>进给速度为零</translation>
        </message>
        <message>
            <source>feed-negative</source>
            <translation>进给速度为负</translation>
        </message>
        <message>
            <source>g-code-unknown</source>
            <translation>未知的 G 代码</translation>
        </message>
        <message>
            <source>m-code-unknown</source>
            <translation>未知的 M 代码</translation>
        </message>
        <message>
            <source>g-code-ignored</source>
            <translation>忽略的 G 代码</translation>
        </message>
        <message>
            <source>m-code-ignored</source>
            <translation>忽略的 M 代码</translation>
        </message>
        <message>
            <source>modal-group-twice</source>
            <translation>同一模态组出现两次</translation>
        </message>
        <message>
            <source>word-twice</source>
            <translation>字重复</translation>
        </message>
        <message>
            <source>word-unused</source>
            <translation>字未被使用</translation>
        </message>
        <message>
            <source>number-expected</source>
            <translation>此处应为数字</translation>
        </message>
        <message>
            <source>number-too-large</source>
            <translation>数字过大</translation>
        </message>
        <message>
            <source>number-not-finite</source>
            <translation>数字不是有限值</translation>
        </message>
        <message>
            <source>bad-number</source>
            <translation>数字无效</translation>
        </message>
        <message>
            <source>bad-character</source>
            <translation>字符无效</translation>
        </message>
        <message>
            <source>bracket-missing</source>
            <translation>缺少括号</translation>
        </message>
        <message>
            <source>comment-not-closed</source>
            <translation>注释未闭合</translation>
        </message>
        <message>
            <source>comment-nested</source>
            <translation>注释嵌套</translation>
        </message>
        <message>
            <source>arc-radius-too-small</source>
            <translation>圆弧半径太小</translation>
        </message>
        <message>
            <source>arc-radius-zero</source>
            <translation>圆弧半径为零</translation>
        </message>
        <message>
            <source>arc-radius-differs</source>
            <translation>圆弧起点与终点半径不一致</translation>
        </message>
        <message>
            <source>arc-radius-and-centre</source>
            <translation>同时给出圆弧半径和圆心</translation>
        </message>
        <message>
            <source>arc-same-point</source>
            <translation>圆弧起点与终点重合</translation>
        </message>
        <message>
            <source>arc-incomplete</source>
            <translation>圆弧不完整</translation>
        </message>
        <message>
            <source>arc-centre-incomplete</source>
            <translation>圆弧圆心不完整</translation>
        </message>
        <message>
            <source>axes-without-motion</source>
            <translation>有轴字但没有运动方式</translation>
        </message>
        <message>
            <source>axes-missing</source>
            <translation>缺少轴字</translation>
        </message>
        <message>
            <source>dwell-negative</source>
            <translation>暂停时间为负</translation>
        </message>
        <message>
            <source>dwell-without-time</source>
            <translation>暂停没有时间</translation>
        </message>
        <message>
            <source>program-without-end</source>
            <translation>程序没有结束</translation>
        </message>
        <message>
            <source>empty-program</source>
            <translation>程序为空</translation>
        </message>
        <message>
            <source>not-text</source>
            <translation>不是文本文件</translation>
        </message>
        <message>
            <source>no-points</source>
            <translation>没有点</translation>
        </message>
        <message>
            <source>header-missing</source>
            <translation>缺少表头</translation>
        </message>
        <message>
            <source>column-unknown</source>
            <translation>未知的列</translation>
        </message>
        <message>
            <source>line-too-long</source>
            <translation>行太长</translation>
        </message>
        <message>
            <source>tool-unknown</source>
            <translation>未知的刀具</translation>
        </message>
        <message>
            <source>spindle-stopped</source>
            <translation>主轴未转动</translation>
        </message>
        <message>
            <source>division-by-zero</source>
            <translation>除以零</translation>
        </message>
        <message>
            <source>parameter-undefined</source>
            <translation>参数未定义</translation>
        </message>
        <message>
            <source>sub-program-unknown</source>
            <translation>未知的子程序</translation>
        </message>
        <message>
            <source>calls-too-deep</source>
            <translation>调用嵌套过深</translation>
        </message>
        <message>
            <source>too-many-turns</source>
            <translation>循环次数过多</translation>
        </message>
        <message>
            <source>compensation-gouge</source>
            <translation>刀补会过切</translation>
        </message>
        <message>
            <source>cycle-without-depth</source>
            <translation>循环没有深度</translation>
        </message>
        <message>
            <source>inverse-time-without-feed</source>
            <translation>反比时间进给缺少 F</translation>
        </message>
        <message>
            <source>code-not-in-dialect</source>
            <translation>该方言没有此代码</translation>
        </message>
        <message>
            <source>value-missing</source>
            <translation>缺少数值</translation>
        </message>
        <message>
            <source>travel-min</source>
            <translation>低于行程</translation>
        </message>
        <message>
            <source>travel-max</source>
            <translation>超出行程</translation>
        </message>
        <message>
            <source>no-speed-limit</source>
            <translation>没有速度限值</translation>
        </message>
        <message>
            <source>no-acceleration-limit</source>
            <translation>没有加速度限值</translation>
        </message>
        <message>
            <source>limits-unbounded</source>
            <translation>限值没有界限</translation>
        </message>
        <message>
            <source>bad-limit</source>
            <translation>限值无效</translation>
        </message>
        <message>
            <source>machine-value</source>
            <translation>机床文件中的值无效</translation>
        </message>
        <message>
            <source>machine-key</source>
            <translation>机床文件中的键未知</translation>
        </message>
        <message>
            <source>machine-syntax</source>
            <translation>机床文件语法错误</translation>
        </message>
        <message>
            <source>cannot-open</source>
            <translation>无法打开</translation>
        </message>
        <message>
            <source>cannot-write</source>
            <translation>无法写入</translation>
        </message>
        <message>
            <source>file-not-found</source>
            <translation>找不到文件</translation>
        </message>
        <message>
            <source>no-permission</source>
            <translation>没有权限</translation>
        </message>
        <message>
            <source>disk-full</source>
            <translation>磁盘已满</translation>
        </message>
        <message>
            <source>import-empty</source>
            <translation>没有找到限值</translation>
        </message>
        <message>
            <source>violation-axis-speed</source>
            <translation>轴速度超限</translation>
        </message>
        <message>
            <source>violation-axis-acceleration</source>
            <translation>轴加速度超限</translation>
        </message>
        <message>
            <source>violation-axis-jerk</source>
            <translation>轴加加速度超限</translation>
        </message>
        <message>
            <source>violation-path-speed</source>
            <translation>路径速度超限</translation>
        </message>
        <message>
            <source>violation-path-acceleration</source>
            <translation>路径加速度超限</translation>
        </message>
        <message>
            <source>violation-path-deceleration</source>
            <translation>路径减速度超限</translation>
        </message>
        <message>
            <source>violation-path-jerk</source>
            <translation>路径加加速度超限</translation>
        </message>
        <message>
            <source>violation-deviation</source>
            <translation>偏离路径</translation>
        </message>
        <message>
            <source>violation-travel-min</source>
            <translation>低于行程</translation>
        </message>
        <message>
            <source>violation-travel-max</source>
            <translation>超出行程</translation>
        </message>
        <message>
            <source>arc-centre-off-plane</source>
            <translation>圆心不在圆弧平面内</translation>
        </message>
        <message>
            <source>arc-radius-too-large</source>
            <translation>圆弧半径过大</translation>
        </message>
        <message>
            <source>arc-turns</source>
            <translation>圆弧圈数无效</translation>
        </message>
        <message>
            <source>atan-needs-two</source>
            <translation>ATAN 需要两个参数</translation>
        </message>
        <message>
            <source>axes-with-g80</source>
            <translation>G80 后不能带坐标字</translation>
        </message>
        <message>
            <source>axis-absent</source>
            <translation>机床没有该轴</translation>
        </message>
        <message>
            <source>axis-not-there</source>
            <translation>机床没有这根轴</translation>
        </message>
        <message>
            <source>bad-line-number</source>
            <translation>行号无效</translation>
        </message>
        <message>
            <source>call-repeats</source>
            <translation>调用重复次数无效</translation>
        </message>
        <message>
            <source>cancelled</source>
            <translation>已取消</translation>
        </message>
        <message>
            <source>closed-pipe</source>
            <translation>输出管道已关闭</translation>
        </message>
        <message>
            <source>column-twice</source>
            <translation>列名重复</translation>
        </message>
        <message>
            <source>compensation-already-on</source>
            <translation>刀补已经生效</translation>
        </message>
        <message>
            <source>compensation-arc-too-small</source>
            <translation>刀补下圆弧半径过小</translation>
        </message>
        <message>
            <source>compensation-entry-short</source>
            <translation>刀补引入段过短</translation>
        </message>
        <message>
            <source>compensation-exit-arc</source>
            <translation>不能在圆弧上取消刀补</translation>
        </message>
        <message>
            <source>compensation-orientation</source>
            <translation>刀尖方位无效</translation>
        </message>
        <message>
            <source>compensation-plane</source>
            <translation>该平面不能用刀补</translation>
        </message>
        <message>
            <source>compensation-without-d</source>
            <translation>刀补缺少 D</translation>
        </message>
        <message>
            <source>coordinate-too-large</source>
            <translation>坐标过大</translation>
        </message>
        <message>
            <source>cycle-inverse-time</source>
            <translation>固定循环不能用反比时间进给</translation>
        </message>
        <message>
            <source>cycle-peck</source>
            <translation>啄钻量无效</translation>
        </message>
        <message>
            <source>cycle-r-below-depth</source>
            <translation>R 平面低于孔底</translation>
        </message>
        <message>
            <source>cycle-repeats</source>
            <translation>循环次数无效</translation>
        </message>
        <message>
            <source>cycle-rotary</source>
            <translation>固定循环不能移动旋转轴</translation>
        </message>
        <message>
            <source>cycle-with-compensation</source>
            <translation>刀补下不能用固定循环</translation>
        </message>
        <message>
            <source>cycle-with-g53</source>
            <translation>固定循环不能与 G53 同用</translation>
        </message>
        <message>
            <source>cycle-without-dwell</source>
            <translation>循环缺少暂停时间 P</translation>
        </message>
        <message>
            <source>lathe-words</source>
            <translation>车削循环的参数有误</translation>
        </message>
        <message>
            <source>lathe-plane</source>
            <translation>车削循环不在XZ平面</translation>
        </message>
        <message>
            <source>lathe-compensation</source>
            <translation>车削循环时刀补未取消</translation>
        </message>
        <message>
            <source>g53-with-cycle</source>
            <translation>G53与循环同用</translation>
        </message>
        <message>
            <source>lathe-contour-motion</source>
            <translation>轮廓中有不允许的运动代码</translation>
        </message>
        <message>
            <source>lathe-contour-unused</source>
            <translation>轮廓中的其他代码无效</translation>
        </message>
        <message>
            <source>lathe-contour-words</source>
            <translation>轮廓的参数有误</translation>
        </message>
        <message>
            <source>lathe-corner-too-large</source>
            <translation>倒角或圆角过大</translation>
        </message>
        <message>
            <source>lathe-contour-turns-back</source>
            <translation>轮廓折返</translation>
        </message>
        <message>
            <source>lathe-contour-empty</source>
            <translation>轮廓为空</translation>
        </message>
        <message>
            <source>lathe-allowance</source>
            <translation>余量过大，轮廓消失</translation>
        </message>
        <message>
            <source>lathe-too-many-passes</source>
            <translation>车削走刀次数过多</translation>
        </message>
        <message>
            <source>tool-not-selected</source>
            <translation>换刀前未选刀</translation>
        </message>
        <message>
            <source>polar-plane</source>
            <translation>极坐标不在XY平面</translation>
        </message>
        <message>
            <source>cycle-without-r</source>
            <translation>循环缺少 R</translation>
        </message>
        <message>
            <source>cycle-words</source>
            <translation>循环字不完整</translation>
        </message>
        <message>
            <source>equals-missing</source>
            <translation>缺少等号</translation>
        </message>
        <message>
            <source>exists-needs-name</source>
            <translation>EXISTS 需要参数名</translation>
        </message>
        <message>
            <source>exit-unreachable</source>
            <translation>循环无法退出</translation>
        </message>
        <message>
            <source>feed-too-large</source>
            <translation>进给过大</translation>
        </message>
        <message>
            <source>file-too-large</source>
            <translation>文件过大</translation>
        </message>
        <message>
            <source>file-trouble</source>
            <translation>文件出错</translation>
        </message>
        <message>
            <source>function-domain</source>
            <translation>函数自变量超出定义域</translation>
        </message>
        <message>
            <source>function-unknown</source>
            <translation>未知函数</translation>
        </message>
        <message>
            <source>g10-form</source>
            <translation>G10 格式错误</translation>
        </message>
        <message>
            <source>g10-ignored</source>
            <translation>G10 被忽略</translation>
        </message>
        <message>
            <source>g10-rotation</source>
            <translation>G10 旋转无效</translation>
        </message>
        <message>
            <source>g10-system</source>
            <translation>G10 坐标系编号无效</translation>
        </message>
        <message>
            <source>g10-without-p</source>
            <translation>G10 缺少 P</translation>
        </message>
        <message>
            <source>g53-incremental</source>
            <translation>增量方式下不能用 G53</translation>
        </message>
        <message>
            <source>g53-polar</source>
            <translation>G53 不能用极坐标</translation>
        </message>
        <message>
            <source>g53-with-arc</source>
            <translation>G53 只能用于 G0 或 G1</translation>
        </message>
        <message>
            <source>g53-with-compensation</source>
            <translation>刀补下不能用 G53</translation>
        </message>
        <message>
            <source>g96-without-s</source>
            <translation>G96 缺少 S</translation>
        </message>
        <message>
            <source>hold-after-end</source>
            <translation>进给保持时刻在程序结束之后</translation>
        </message>
        <message>
            <source>joint-axis-guessed</source>
            <translation>关节对应的轴是推测的</translation>
        </message>
        <message>
            <source>joint-axis-unknown</source>
            <translation>关节不对应任何轴</translation>
        </message>
        <message>
            <source>hold-needs-path</source>
            <translation>平滑拐角下不能插入进给保持</translation>
        </message>
        <message>
            <source>hold-time</source>
            <translation>进给保持时刻无效</translation>
        </message>
        <message>
            <source>is-directory</source>
            <translation>是文件夹</translation>
        </message>
        <message>
            <source>line-number-unknown</source>
            <translation>找不到跳转的行号</translation>
        </message>
        <message>
            <source>lookahead-zero</source>
            <translation>前瞻段数至少为 1</translation>
        </message>
        <message>
            <source>loop-unmatched</source>
            <translation>循环首尾不匹配</translation>
        </message>
        <message>
            <source>m-code-user</source>
            <translation>用户 M 代码被忽略</translation>
        </message>
        <message>
            <source>m98-without-p</source>
            <translation>M98 缺少 P</translation>
        </message>
        <message>
            <source>macro-without-p</source>
            <translation>宏调用缺少 P</translation>
        </message>
        <message>
            <source>more-of-the-same</source>
            <translation>同类问题还有更多</translation>
        </message>
        <message>
            <source>name-empty</source>
            <translation>参数名为空</translation>
        </message>
        <message>
            <source>name-not-closed</source>
            <translation>参数名缺少 &gt;</translation>
        </message>
        <message>
            <source>nesting-too-deep</source>
            <translation>嵌套过深</translation>
        </message>
        <message>
            <source>no-steppers</source>
            <translation>没有步进轴</translation>
        </message>
        <message>
            <source>number-out-of-range</source>
            <translation>数值超出范围</translation>
        </message>
        <message>
            <source>o-word-computed</source>
            <translation>O 字标签不能计算</translation>
        </message>
        <message>
            <source>o-word-duplicate</source>
            <translation>O 字标签重复</translation>
        </message>
        <message>
            <source>o-word-label</source>
            <translation>O 字标签无效</translation>
        </message>
        <message>
            <source>o-word-misplaced</source>
            <translation>O 字位置错误</translation>
        </message>
        <message>
            <source>o-word-unknown</source>
            <translation>未知 O 字</translation>
        </message>
        <message>
            <source>o-word-unmatched</source>
            <translation>O 字首尾不匹配</translation>
        </message>
        <message>
            <source>offset-with-compensation</source>
            <translation>刀补下不能更改偏置</translation>
        </message>
        <message>
            <source>operator-unknown</source>
            <translation>未知运算符</translation>
        </message>
        <message>
            <source>parameter-file-line</source>
            <translation>参数文件行无效</translation>
        </message>
        <message>
            <source>parameter-not-integer</source>
            <translation>参数号必须是整数</translation>
        </message>
        <message>
            <source>parameter-out-of-range</source>
            <translation>参数号超出范围</translation>
        </message>
        <message>
            <source>parameter-read-only</source>
            <translation>参数只读</translation>
        </message>
        <message>
            <source>path-not-finite</source>
            <translation>路径坐标不是有限数</translation>
        </message>
        <message>
            <source>pitch-missing</source>
            <translation>缺少螺距</translation>
        </message>
        <message>
            <source>plane-with-compensation</source>
            <translation>刀补下不能换平面</translation>
        </message>
        <message>
            <source>polar-angle-unknown</source>
            <translation>极角未知</translation>
        </message>
        <message>
            <source>polar-with-axis-words</source>
            <translation>极坐标不能与坐标字同用</translation>
        </message>
        <message>
            <source>power-of-negative</source>
            <translation>负数不能取小数次幂</translation>
        </message>
        <message>
            <source>probe-goes-nowhere</source>
            <translation>探测没有位移</translation>
        </message>
        <message>
            <source>probe-inverse-time</source>
            <translation>探测不能用反比时间进给</translation>
        </message>
        <message>
            <source>probe-with-compensation</source>
            <translation>刀补下不能探测</translation>
        </message>
        <message>
            <source>program-alarm</source>
            <translation>程序报警</translation>
        </message>
        <message>
            <source>program-refused</source>
            <translation>程序有错误</translation>
        </message>
        <message>
            <source>program-repeats</source>
            <translation>程序无限重复</translation>
        </message>
        <message>
            <source>reading-stopped</source>
            <translation>读取已停止</translation>
        </message>
        <message>
            <source>return-without-call</source>
            <translation>没有调用却返回</translation>
        </message>
        <message>
            <source>rotation-plane</source>
            <translation>旋转平面无效</translation>
        </message>
        <message>
            <source>servo-unstable</source>
            <translation>位置环不稳定</translation>
        </message>
        <message>
            <source>servo-value</source>
            <translation>伺服参数无效</translation>
        </message>
        <message>
            <source>setpoint-columns</source>
            <translation>设定点列不一致</translation>
        </message>
        <message>
            <source>setpoint-format-unknown</source>
            <translation>未知的设定点格式</translation>
        </message>
        <message>
            <source>setpoint-not-finite</source>
            <translation>设定点不是有限数</translation>
        </message>
        <message>
            <source>setpoint-rows</source>
            <translation>设定点行不连续</translation>
        </message>
        <message>
            <source>setpoints-axes</source>
            <translation>设定点轴不符</translation>
        </message>
        <message>
            <source>setpoints-broken</source>
            <translation>设定点文件损坏</translation>
        </message>
        <message>
            <source>setpoints-empty</source>
            <translation>设定点文件为空</translation>
        </message>
        <message>
            <source>setpoints-header</source>
            <translation>设定点表头无效</translation>
        </message>
        <message>
            <source>setpoints-shape</source>
            <translation>设定点数组形状不符</translation>
        </message>
        <message>
            <source>setpoints-time</source>
            <translation>设定点时间无效</translation>
        </message>
        <message>
            <source>speed-above-feed</source>
            <translation>速度高于进给</translation>
        </message>
        <message>
            <source>speed-negative</source>
            <translation>速度为负</translation>
        </message>
        <message>
            <source>spindle-direction</source>
            <translation>主轴方向无效</translation>
        </message>
        <message>
            <source>spline-axes</source>
            <translation>样条轴无效</translation>
        </message>
        <message>
            <source>spline-not-closed</source>
            <translation>样条未结束</translation>
        </message>
        <message>
            <source>spline-not-open</source>
            <translation>样条未开始</translation>
        </message>
        <message>
            <source>spline-order</source>
            <translation>样条阶数无效</translation>
        </message>
        <message>
            <source>spline-plane</source>
            <translation>样条平面无效</translation>
        </message>
        <message>
            <source>spline-too-long</source>
            <translation>样条过长</translation>
        </message>
        <message>
            <source>spline-too-short</source>
            <translation>样条控制点太少</translation>
        </message>
        <message>
            <source>spline-weight</source>
            <translation>样条权重无效</translation>
        </message>
        <message>
            <source>spline-with-compensation</source>
            <translation>刀补下不能用样条</translation>
        </message>
        <message>
            <source>spline-words</source>
            <translation>样条字不完整</translation>
        </message>
        <message>
            <source>state-not-saved</source>
            <translation>没有保存的状态可恢复</translation>
        </message>
        <message>
            <source>stream-too-long</source>
            <translation>数据流过长</translation>
        </message>
        <message>
            <source>sub-program-kind</source>
            <translation>子程序类型不符</translation>
        </message>
        <message>
            <source>text-after-o-word</source>
            <translation>O 字后有多余文字</translation>
        </message>
        <message>
            <source>then-missing</source>
            <translation>缺少 THEN</translation>
        </message>
        <message>
            <source>thread-plane</source>
            <translation>螺纹平面无效</translation>
        </message>
        <message>
            <source>thread-words</source>
            <translation>螺纹字不完整</translation>
        </message>
        <message>
            <source>timer-too-fast</source>
            <translation>定时器频率过高</translation>
        </message>
        <message>
            <source>timer-too-slow</source>
            <translation>定时器频率过低</translation>
        </message>
        <message>
            <source>timer-value</source>
            <translation>定时器频率无效</translation>
        </message>
        <message>
            <source>tolerance-negative</source>
            <translation>公差为负</translation>
        </message>
        <message>
            <source>too-many-arguments</source>
            <translation>参数过多</translation>
        </message>
        <message>
            <source>too-many-blocks</source>
            <translation>程序段过多</translation>
        </message>
        <message>
            <source>too-many-lines</source>
            <translation>行数过多</translation>
        </message>
        <message>
            <source>too-many-modes</source>
            <translation>模态组合过多</translation>
        </message>
        <message>
            <source>too-many-names</source>
            <translation>参数名过多</translation>
        </message>
        <message>
            <source>too-many-values</source>
            <translation>数值过多</translation>
        </message>
        <message>
            <source>tool-change-with-compensation</source>
            <translation>刀补下不能换刀</translation>
        </message>
        <message>
            <source>tool-number</source>
            <translation>刀号无效</translation>
        </message>
        <message>
            <source>tool-orientation</source>
            <translation>刀具方位无效</translation>
        </message>
        <message>
            <source>tool-table-number</source>
            <translation>刀具表中的数无效</translation>
        </message>
        <message>
            <source>tool-table-word</source>
            <translation>刀具表中的字无效</translation>
        </message>
        <message>
            <source>tube-unbounded</source>
            <translation>平滑拐角需要各轴有限值</translation>
        </message>
        <message>
            <source>two-codes-want-axes</source>
            <translation>两个代码都要坐标字</translation>
        </message>
        <message>
            <source>g43.1-without-axes</source>
            <translation>G43.1 没有轴字</translation>
        </message>
        <message>
            <source>g43.2-without-h</source>
            <translation>G43.2 没有刀具号 H</translation>
        </message>
        <message>
            <source>not-regular-file</source>
            <translation>这不是普通文件，而是管道、套接字或设备</translation>
        </message>
        <message>
            <source>picture-format-unknown</source>
            <translation>不支持这种图片格式</translation>
        </message>
        <message>
            <source>import-value</source>
            <translation>控制器设置中的值无效</translation>
        </message>
        <message>
            <source>machine-unwritable</source>
            <translation>无法写成机床文件</translation>
        </message>
        <message>
            <source>arc-mended</source>
            <translation>圆弧终点偏离半径，已按螺线处理</translation>
        </message>
        <message>
            <source>dialect-uncertain</source>
            <translation>方言不能确定</translation>
        </message>
        <message>
            <source>corner-off-plane</source>
            <translation>拐角不在平面内</translation>
        </message>
        <message>
            <source>corner-size</source>
            <translation>拐角尺寸无效</translation>
        </message>
        <message>
            <source>corner-too-large</source>
            <translation>拐角放不下</translation>
        </message>
        <message>
            <source>corner-without-move</source>
            <translation>拐角之后没有移动</translation>
        </message>
        <message>
            <source>corner-word</source>
            <translation>逗号后的词无效</translation>
        </message>
        <message>
            <source>increment-twice</source>
            <translation>同一轴给出两次</translation>
        </message>
        <message>
            <source>program-abort</source>
            <translation>程序自行中止</translation>
        </message>
        <message>
            <source>spindle-number</source>
            <translation>没有这个主轴</translation>
        </message>
        <message>
            <source>system-number</source>
            <translation>没有这个坐标系</translation>
        </message>
        <message>
            <source>text-behind-percent</source>
            <translation>% 之后的文字未读取</translation>
        </message>
        <message>
            <source>lathe-contour-lines</source>
            <translation>找不到轮廓的程序行</translation>
        </message>
        <message>
            <source>lathe-system-b</source>
            <translation>按 G 代码体系 B 读取</translation>
        </message>
        <message>
            <source>machine-coordinates-under-tip</source>
            <translation>刀尖编程时使用了机床坐标</translation>
        </message>
        <message>
            <source>out-of-plane</source>
            <translation>刀轴未在平面内转动</translation>
        </message>
        <message>
            <source>rotary-unwinds</source>
            <translation>旋转轴须反向绕回</translation>
        </message>
        <message>
            <source>tool-vector-zero</source>
            <translation>刀具矢量为零</translation>
        </message>
        <message>
            <source>tool-vector-with-angles</source>
            <translation>刀具矢量与旋转轴并存</translation>
        </message>
        <message>
            <source>setpoints-lines</source>
            <translation>设定点文件没有行号列</translation>
        </message>
        <message>
            <source>kinematics-missing</source>
            <translation>缺少 [kinematics]</translation>
        </message>
        <message>
            <source>tool-length-missing</source>
            <translation>缺少刀具长度</translation>
        </message>
        <message>
            <source>setpoint-columns-unnamed</source>
            <translation>该格式没有列名</translation>
        </message>
        <message>
            <source>tool-direction-unreachable</source>
            <translation>旋转轴无法达到该刀具方向</translation>
        </message>
        <message>
            <source>rotary-travel</source>
            <translation>超出旋转轴行程</translation>
        </message>
        <message>
            <source>setvn-unreadable</source>
            <translation>SETVN 需要首个变量号和方括号中的名称</translation>
        </message>
        <message>
            <source>output-ignored</source>
            <translation>输出到端口的内容已忽略</translation>
        </message>
        <message>
            <source>sender-macro</source>
            <translation>打印机的宏未执行</translation>
        </message>
        <message>
            <source>sub-program-missing</source>
            <translation>缺少子程序</translation>
        </message>
        <message>
            <source>accuracy-level</source>
            <translation>没有这个精度等级</translation>
        </message>
        <message>
            <source>corner-limit-without-effect</source>
            <translation>程序的拐角限值在此不起作用</translation>
        </message>
        <message>
            <source>limit-not-positive</source>
            <translation>限值不大于 0</translation>
        </message>
        <message>
            <source>limit-without-effect</source>
            <translation>限值设定对规划不起作用</translation>
        </message>
        <message>
            <source>limits-change-in-tube</source>
            <translation>圆滑运动中限值有变化</translation>
        </message>
        <message>
            <source>macro-operation</source>
            <translation>未知的宏运算</translation>
        </message>
        <message>
            <source>macro-undefined</source>
            <translation>宏运算没有结果</translation>
        </message>
        <message>
            <source>macro-variable</source>
            <translation>宏变量不可赋值</translation>
        </message>
        <message>
            <source>main-program-behind</source>
            <translation>主程序位于子程序之后</translation>
        </message>
        <message>
            <source>tool-table-missing</source>
            <translation>缺少刀具表</translation>
        </message>
        <message>
            <source>polar-incremental</source>
            <translation>G91 下的极坐标半径</translation>
        </message>
        <message>
            <source>dwell-uncertain</source>
            <translation>停顿时间的单位不能确定</translation>
        </message>
        <message>
            <source>arc-scaled-unevenly</source>
            <translation>圆弧所在平面的两轴缩放不同</translation>
        </message>
        <message>
            <source>g-code-machine</source>
            <translation>机床自定义的 G 代码</translation>
        </message>
        <message>
            <source>integers-are-increments</source>
            <translation>无小数点的坐标按最小单位读取</translation>
        </message>
        <message>
            <source>integers-are-lengths</source>
            <translation>无小数点的坐标按长度读取</translation>
        </message>
        <message>
            <source>several-channels</source>
            <translation>程序含有多个通道</translation>
        </message>
        <message>
            <source>units-missing</source>
            <translation>没有给出单位</translation>
        </message>
        <message>
            <source>text-behind-end</source>
            <translation>程序结束之后还有运动</translation>
        </message>
        <message>
            <source>feed-a-turn</source>
            <translation>按每转进给读取</translation>
        </message>
        <message>
            <source>tip-doubtful</source>
            <translation>旋转轴是否绕刀尖运动不明</translation>
        </message>
        <message>
            <source>program-number</source>
            <translation>程序号缺少字母 O</translation>
        </message>
        <message>
            <source>language-unsupported</source>
            <translation>不支持这种语言</translation>
        </message>
        <message>
            <source>lathe-chamfer</source>
            <translation>C 按倒角读取</translation>
        </message>
        <message>
            <source>line-angle</source>
            <translation>直线的角度无效</translation>
        </message>
        <message>
            <source>line-angle-open</source>
            <translation>直线没有终点</translation>
        </message>
        <message>
            <source>pattern-without-cycle</source>
            <translation>孔阵没有固定循环</translation>
        </message>
        <message>
            <source>pattern-words</source>
            <translation>孔阵缺少词</translation>
        </message>
        <message>
            <source>peck-in-increments</source>
            <translation>啄钻深度按最小单位读取</translation>
        </message>
        <message>
            <source>pocket-plane</source>
            <translation>圆槽不在 XY 平面</translation>
        </message>
        <message>
            <source>pocket-tool-unknown</source>
            <translation>圆槽刀具半径未知</translation>
        </message>
        <message>
            <source>pocket-words</source>
            <translation>圆槽缺少词</translation>
        </message>
        <message>
            <source>scale-factor</source>
            <translation>缩放系数无效</translation>
        </message>
        <message>
            <source>scale-missing</source>
            <translation>没有缩放系数</translation>
        </message>
        <message>
            <source>lathe-level</source>
            <translation>R 按绝对位置读取</translation>
        </message>
        <message>
            <source>arc-centre-absolute</source>
            <translation>圆心按绝对坐标读取</translation>
        </message>
        <message>
            <source>settings-included</source>
            <translation>写在被包含的文件里</translation>
        </message>
        <message>
            <source>settings-unwritable</source>
            <translation>无法写入该设置</translation>
        </message>
        <message>
            <source>controller-over-limit</source>
            <translation>超出轴的限值</translation>
        </message>
        <message>
            <source>extruder-not-counted</source>
            <translation>未计入挤出机</translation>
        </message>
        <message>
            <source>shaper-stops</source>
            <translation>成形的设定点在拐角处停止：拐角规则允许的速度突变无法成形</translation>
        </message>
        <message>
            <source>accelerometer-still</source>
            <translation>加速度计没有测到任何信号</translation>
        </message>
        <message>
            <source>accelerometer-saturated</source>
            <translation>加速度计已饱和</translation>
        </message>
        <message>
            <source>accelerometer-no-peak</source>
            <translation>加速度计数据中没有突出的模态</translation>
        </message>
        <message>
            <source>accelerometer-columns</source>
            <translation>无法确定哪些列是加速度</translation>
        </message>
        <message>
            <source>accelerometer-short</source>
            <translation>记录太短，无法从中找出模态</translation>
        </message>
        <message>
            <source>accelerometer-uneven</source>
            <translation>记录的采样间隔不均匀</translation>
        </message>
        <message>
            <source>accelerometer-known</source>
            <translation>该模态已是此轴的 resonance_hz</translation>
        </message>
    </context>
    <context>
        <name>remedies</name>
        <message>
            <source>a trace is a table of numbers with a name above each column</source>
            <translation>测量轨迹是一张数字表，每列上方有名称</translation>
        </message>
        <message>
            <source>add [gcode_arcs] to the printer.cfg</source>
            <translation>在 printer.cfg 中加入 [gcode_arcs]</translation>
        </message>
        <message>
            <source>check that the trace is of these setpoints, of the slide, and not filtered</source>
            <translation>请检查轨迹是否属于这些设定点、取自滑台且未经滤波</translation>
        </message>
        <message>
            <source>cut the trace there</source>
            <translation>请在该处截断轨迹</translation>
        </message>
        <message>
            <source>cut the trace there, or record again without lost samples</source>
            <translation>请在该处截断轨迹，或重新记录且不丢样本</translation>
        </message>
        <message>
            <source>cut the trace to where all of its channels were recorded</source>
            <translation>请把轨迹截取到所有通道都有记录的部分</translation>
        </message>
        <message>
            <source>each row needs a number in every column; record all channels at one rate</source>
            <translation>每行的每一列都需要一个数；请以同一采样率记录所有通道</translation>
        </message>
        <message>
            <source>give M205 J of a firmware with junction deviation</source>
            <translation>给出采用 junction deviation 的固件的 M205 J</translation>
        </message>
        <message>
            <source>give an answer to $$, a printer.cfg, a report of M503 or a LinuxCNC .ini</source>
            <translation>给出 $$ 的回答、printer.cfg、M503 报告或 LinuxCNC 的 .ini</translation>
        </message>
        <message>
            <source>give mm, um, nm, m, in, deg or rad in brackets</source>
            <translation>请在方括号中给出 mm、um、nm、m、in、deg 或 rad</translation>
        </message>
        <message>
            <source>give s, ms, us, ns or min in brackets</source>
            <translation>请在方括号中给出 s、ms、us、ns 或 min</translation>
        </message>
        <message>
            <source>give setpoints as they were commanded</source>
            <translation>请给出实际下达的设定点</translation>
        </message>
        <message>
            <source>give the .ini that has it</source>
            <translation>给出含有它的 .ini</translation>
        </message>
        <message>
            <source>give the printer.cfg that has it</source>
            <translation>给出含有它的 printer.cfg</translation>
        </message>
        <message>
            <source>give --controller %1, or another file</source>
            <translation>写 --controller %1，或换一个文件</translation>
        </message>
        <message>
            <source>give a shorter --tacc-ms and --tdec-ms</source>
            <translation>请减小 --tacc-ms 和 --tdec-ms</translation>
        </message>
        <message>
            <source>give the setpoints that were run, and check which column is which axis</source>
            <translation>请给出实际运行的设定点，并检查各列对应哪个轴</translation>
        </message>
        <message>
            <source>name it with --columns t=NAME, or give the time from row to row with --trace-period-ms</source>
            <translation>请用 --columns t=名称 指定该列，或用 --trace-period-ms 给出行间时间</translation>
        </message>
        <message>
            <source>give resonance_hz of the axis that shakes in [servo.X] of the machine file; &apos;toolpace identify&apos; finds it in a trace</source>
            <translation>请在机床文件的 [servo.X] 中给出振动轴的 resonance_hz；“toolpace identify” 可从跟踪数据中找到它</translation>
        </message>
        <message>
            <source>record a program that moves it</source>
            <translation>请记录一个让该轴运动的程序</translation>
        </message>
        <message>
            <source>record again with a larger buffer (depth of the sampler)</source>
            <translation>请用更大的缓冲区（采样器深度）重新记录</translation>
        </message>
        <message>
            <source>record again with a larger range of this channel</source>
            <translation>请以更大的通道量程重新记录</translation>
        </message>
        <message>
            <source>record at least the motion of a few blocks</source>
            <translation>请至少记录几个程序段的运动</translation>
        </message>
        <message>
            <source>record the time with more digits, or one recording at a time</source>
            <translation>请以更多位数记录时间，或每次只记录一段</translation>
        </message>
        <message>
            <source>record while the program runs</source>
            <translation>请在程序运行时记录</translation>
        </message>
        <message>
            <source>say its column and unit: --columns x=NAME[mm], with mm, um, m, in, deg or rad</source>
            <translation>请说明其列和单位：--columns x=名称[mm]，单位为 mm、um、m、in、deg 或 rad</translation>
        </message>
        <message>
            <source>say which columns are which axis: --columns x=NAME,y=NAME</source>
            <translation>请说明各列对应哪个轴：--columns x=名称,y=名称</translation>
        </message>
        <message>
            <source>say which is which: --columns t=1,x=2; the columns are %1</source>
            <translation>请说明各列含义：--columns t=1,x=2；现有的列为 %1</translation>
        </message>
        <message>
            <source>the columns are %1</source>
            <translation>现有的列为 %1</translation>
        </message>
        <message>
            <source>try again when it is written</source>
            <translation>等它写完后再试</translation>
        </message>
        <message>
            <source>split the program, or give more memory</source>
            <translation>把程序分成几段，或增加内存</translation>
        </message>
        <message>
            <source>please report it</source>
            <translation>请报告此问题</translation>
        </message>
        <message>
            <source>write t=NAME,x=NAME, … with names or numbers of columns; a unit may follow: x=3[um]; commanded positions are commanded_x</source>
            <translation>请写 t=名称,x=名称,…，可用列名或列号；后面可带单位：x=3[um]；指令位置写作 commanded_x</translation>
        </message>
        <message>
            <source>write to another file</source>
            <translation>写到另一个文件</translation>
        </message>
        <message>
            <source>write to different files</source>
            <translation>写到不同的文件</translation>
        </message>
        <message>
            <source>put the file itself there, or give the folder it lies in with --sub-path</source>
            <translation>把文件本身放到那里，或用 --sub-path 给出它所在的文件夹</translation>
        </message>
        <message>
            <source>call fewer files</source>
            <translation>少调用一些文件</translation>
        </message>
        <message>
            <source>split it</source>
            <translation>把它分成几段</translation>
        </message>
        <message>
            <source>write it again, or copy it again</source>
            <translation>重新写出，或重新复制</translation>
        </message>
        <message>
            <source>give one of them</source>
            <translation>写其中一个</translation>
        </message>
        <message>
            <source>the size of a corner is not below 0</source>
            <translation>拐角尺寸不小于 0</translation>
        </message>
        <message>
            <source>R is the way back from the work</source>
            <translation>R 是离开工件的退刀量</translation>
        </message>
        <message>
            <source>a contour is made of G0, G1, G2 and G3</source>
            <translation>轮廓由 G0、G1、G2 和 G3 组成</translation>
        </message>
        <message>
            <source>give a larger step I, or a simpler contour</source>
            <translation>增大步长 I，或简化轮廓</translation>
        </message>
        <message>
            <source>A rounds it, C breaks it: give one</source>
            <translation>A 倒圆，C 倒角：只写一个</translation>
        </message>
        <message>
            <source>call it outside</source>
            <translation>在外面调用</translation>
        </message>
        <message>
            <source>a contour has two moves at least: one to its start and one along it</source>
            <translation>轮廓至少有两个移动：一个到起点，一个沿轮廓</translation>
        </message>
        <message>
            <source>name the sub-program of the contour with Q: Q100 for O100 sub</source>
            <translation>用 Q 指定轮廓子程序：O100 sub 用 Q100</translation>
        </message>
        <message>
            <source>give a smaller allowance D (of G70 also E)</source>
            <translation>减小余量 D（G70 还有 E）</translation>
        </message>
        <message>
            <source>give feed, speed and other codes before the lathe cycle</source>
            <translation>在车削循环之前给出进给、速度和其他代码</translation>
        </message>
        <message>
            <source>I is the depth of a pass</source>
            <translation>I 是每刀切深</translation>
        </message>
        <message>
            <source>end it with G40; G70 alone finishes with it</source>
            <translation>用 G40 结束；只有 G70 可带它精车</translation>
        </message>
        <message>
            <source>P is a whole number from 1 to 1000</source>
            <translation>P 是 1 到 1000 的整数</translation>
        </message>
        <message>
            <source>go there before with G53 G0</source>
            <translation>先用 G53 G0 到那里</translation>
        </message>
        <message>
            <source>give a smaller A or C</source>
            <translation>A 或 C 取小一些</translation>
        </message>
        <message>
            <source>%1 numbers are due in each line</source>
            <translation>每行应有 %1 个数</translation>
        </message>
        <message>
            <source>D is the highest speed of the spindle</source>
            <translation>D 是主轴最高转速</translation>
        </message>
        <message>
            <source>D takes a tool number</source>
            <translation>D 后面是刀号</translation>
        </message>
        <message>
            <source>G76 needs P Z I J K</source>
            <translation>G76 需要 P Z I J K</translation>
        </message>
        <message>
            <source>G87 needs I J K</source>
            <translation>G87 需要 I J K</translation>
        </message>
        <message>
            <source>H is a whole number from 0</source>
            <translation>H 须为不小于 0 的整数</translation>
        </message>
        <message>
            <source>H is a whole number from 0 to 10000</source>
            <translation>H 是 0 到 10000 的整数</translation>
        </message>
        <message>
            <source>J is the first cut, K the full depth, both positive, K the larger</source>
            <translation>J 是第一刀，K 是总深，两者为正且 K 较大</translation>
        </message>
        <message>
            <source>L is a whole number from 0 to 999999999</source>
            <translation>L 是 0 到 999999999 的整数</translation>
        </message>
        <message>
            <source>L: 1 entry taper, 2 exit taper, 3 both</source>
            <translation>L：1 入口锥，2 出口锥，3 两者</translation>
        </message>
        <message>
            <source>N stands at the beginning of the line</source>
            <translation>N 写在行首</translation>
        </message>
        <message>
            <source>P and Q of G64 are not below 0</source>
            <translation>G64 的 P 和 Q 不小于 0</translation>
        </message>
        <message>
            <source>P of an arc is a whole number from 1 to 1000000</source>
            <translation>圆弧的 P 是 1 到 1000000 的整数</translation>
        </message>
        <message>
            <source>P0 is the active system, P1 to P9 are G54 to G59.3</source>
            <translation>P0 是当前坐标系，P1 到 P9 是 G54 到 G59.3</translation>
        </message>
        <message>
            <source>Q is the slide angle in degrees</source>
            <translation>Q 是进刀角度（度）</translation>
        </message>
        <message>
            <source>T and P are whole numbers from 0 to 99999999, Q is one from 0 to 9</source>
            <translation>T 和 P 是 0 到 99999999 的整数，Q 是 0 到 9 的整数</translation>
        </message>
        <message>
            <source>a feedrate is not below 0</source>
            <translation>进给速度不小于 0</translation>
        </message>
        <message>
            <source>a line is a parameter number and a value</source>
            <translation>每行是一个参数号和一个值</translation>
        </message>
        <message>
            <source>a spindle speed is not below 0</source>
            <translation>主轴转速不小于 0</translation>
        </message>
        <message>
            <source>add it to the tool table</source>
            <translation>把它加入刀具表</translation>
        </message>
        <message>
            <source>add rows</source>
            <translation>增加数据行</translation>
        </message>
        <message>
            <source>an O word stands first in its line</source>
            <translation>O 字写在行首</translation>
        </message>
        <message>
            <source>assign it before it is used, or test it with EXISTS[]</source>
            <translation>使用前先赋值，或用 EXISTS[] 检查</translation>
        </message>
        <message>
            <source>axes are X Y Z A B C</source>
            <translation>轴有 X Y Z A B C</translation>
        </message>
        <message>
            <source>begin with a header such as x_mm,y_mm,z_mm,feed_mm_min</source>
            <translation>以表头开始，如 x_mm,y_mm,z_mm,feed_mm_min</translation>
        </message>
        <message>
            <source>call a sub with O… call, an O number with M98</source>
            <translation>sub 用 O… call 调用，O 号用 M98 调用</translation>
        </message>
        <message>
            <source>check G17 G18 G19</source>
            <translation>检查 G17 G18 G19</translation>
        </message>
        <message>
            <source>check I J K or R</source>
            <translation>检查 I J K 或 R</translation>
        </message>
        <message>
            <source>check R and the depth</source>
            <translation>检查 R 和深度</translation>
        </message>
        <message>
            <source>check feeds and dwells, or take a longer period</source>
            <translation>检查进给和暂停，或取更长的周期</translation>
        </message>
        <message>
            <source>check for a sub-program that calls itself; --max-call-depth raises the bound</source>
            <translation>检查是否有子程序调用自身；--max-call-depth 可提高上限</translation>
        </message>
        <message>
            <source>check it</source>
            <translation>检查它</translation>
        </message>
        <message>
            <source>check its permissions</source>
            <translation>检查它的权限</translation>
        </message>
        <message>
            <source>check that every sub, if, while, do and repeat is closed under the same label</source>
            <translation>检查每个 sub、if、while、do 和 repeat 是否都以同一标号结束</translation>
        </message>
        <message>
            <source>check that its loops end; --max-blocks raises the bound</source>
            <translation>检查循环能否结束；--max-blocks 可提高上限</translation>
        </message>
        <message>
            <source>check that its loops end; --max-lines raises the bound</source>
            <translation>检查循环能否结束；--max-lines 可提高上限</translation>
        </message>
        <message>
            <source>check that the loop ends; --max-loop-turns raises the bound</source>
            <translation>检查循环能否结束；--max-loop-turns 可提高上限</translation>
        </message>
        <message>
            <source>check the L word</source>
            <translation>检查 L 字</translation>
        </message>
        <message>
            <source>check the argument</source>
            <translation>检查参数</translation>
        </message>
        <message>
            <source>check the base</source>
            <translation>检查底数</translation>
        </message>
        <message>
            <source>check the centre words I J K</source>
            <translation>检查圆心字 I J K</translation>
        </message>
        <message>
            <source>check the centre words I J K, G90.1/G91.1, and the plane</source>
            <translation>检查圆心字 I J K、G90.1/G91.1 和平面</translation>
        </message>
        <message>
            <source>check the code or the dialect</source>
            <translation>检查代码或方言</translation>
        </message>
        <message>
            <source>check the digits</source>
            <translation>检查数字</translation>
        </message>
        <message>
            <source>check the disk</source>
            <translation>检查磁盘</translation>
        </message>
        <message>
            <source>check the expression</source>
            <translation>检查表达式</translation>
        </message>
        <message>
            <source>check the feedrate</source>
            <translation>检查进给速度</translation>
        </message>
        <message>
            <source>check the folder and the extension</source>
            <translation>检查文件夹和扩展名</translation>
        </message>
        <message>
            <source>check the name</source>
            <translation>检查名称</translation>
        </message>
        <message>
            <source>check the name and the permissions</source>
            <translation>检查名称和权限</translation>
        </message>
        <message>
            <source>check the name and the rights</source>
            <translation>检查名称和权限</translation>
        </message>
        <message>
            <source>check the number behind GOTO</source>
            <translation>检查 GOTO 后面的数</translation>
        </message>
        <message>
            <source>check the number behind P</source>
            <translation>检查 P 后面的数</translation>
        </message>
        <message>
            <source>check the numbers</source>
            <translation>检查数值</translation>
        </message>
        <message>
            <source>check the numbers and the offsets</source>
            <translation>检查数值和偏置</translation>
        </message>
        <message>
            <source>check the numbers of this line</source>
            <translation>检查本行的数值</translation>
        </message>
        <message>
            <source>correct them first</source>
            <translation>请先改正这些错误</translation>
        </message>
        <message>
            <source>check the path</source>
            <translation>检查路径</translation>
        </message>
        <message>
            <source>check the rights of the file and its directory</source>
            <translation>检查文件及其文件夹的权限</translation>
        </message>
        <message>
            <source>read the part of each channel as a program of its own</source>
            <translation>把每个通道的部分作为单独的程序读取</translation>
        </message>
        <message>
            <source>remove what stands behind the end, or the end</source>
            <translation>删去程序结束之后的内容，或删去该结束</translation>
        </message>
        <message>
            <source>write G20 for inches, or G21 for mm, at the beginning</source>
            <translation>在开头写 G20（英寸）或 G21（毫米）</translation>
        </message>
        <message>
            <source>say G98 or G99, or choose --dialect fanuc-lathe-b for a feed a minute</source>
            <translation>写 G98 或 G99；若要每分钟进给，请选 --dialect fanuc-lathe-b</translation>
        </message>
        <message>
            <source>repeat the whole sub-program, or call it several times</source>
            <translation>重复整个子程序，或多次调用它</translation>
        </message>
        <message>
            <source>write O before it</source>
            <translation>在它前面写 O</translation>
        </message>
        <message>
            <source>check what your controller does with it</source>
            <translation>查明你的控制器如何处理它</translation>
        </message>
        <message>
            <source>choose a time before the end</source>
            <translation>选一个结束之前的时刻</translation>
        </message>
        <message>
            <source>choose another file</source>
            <translation>选别的文件</translation>
        </message>
        <message>
            <source>choose the dialect with --dialect</source>
            <translation>用 --dialect 选择方言</translation>
        </message>
        <message>
            <source>choose the machine that it is for, or describe the axis in [axes.%1]</source>
            <translation>选择适合该程序的机床，或在 [axes.%1] 中描述该轴</translation>
        </message>
        <message>
            <source>close DO1 with END1 in the same program</source>
            <translation>在同一程序中用 END1 结束 DO1</translation>
        </message>
        <message>
            <source>close it under the same label</source>
            <translation>用同一标号结束它</translation>
        </message>
        <message>
            <source>close the bracket</source>
            <translation>补上右括号</translation>
        </message>
        <message>
            <source>close the comment with &apos;)&apos;</source>
            <translation>用 &apos;)&apos; 结束注释</translation>
        </message>
        <message>
            <source>close the name with &apos;&gt;&apos;</source>
            <translation>用 &apos;&gt;&apos; 结束名称</translation>
        </message>
        <message>
            <source>columns are x_mm y_mm z_mm a_deg b_deg c_deg feed_mm_min</source>
            <translation>列名有 x_mm y_mm z_mm a_deg b_deg c_deg feed_mm_min</translation>
        </message>
        <message>
            <source>comments do not nest: remove the inner parenthesis</source>
            <translation>注释不能嵌套：去掉里面的括号</translation>
        </message>
        <message>
            <source>correct the value</source>
            <translation>改正数值</translation>
        </message>
        <message>
            <source>define it in this program, or put its file beside the program or into a folder given with --sub-path</source>
            <translation>在本程序中定义它，或把它的文件放在程序旁边或 --sub-path 给出的文件夹中</translation>
        </message>
        <message>
            <source>did you mean &apos;%1&apos;?</source>
            <translation>是否想写“%1”？</translation>
        </message>
        <message>
            <source>end it with G40 first</source>
            <translation>先用 G40 结束</translation>
        </message>
        <message>
            <source>end it with M2 or M30</source>
            <translation>用 M2 或 M30 结束</translation>
        </message>
        <message>
            <source>end it with M30</source>
            <translation>用 M30 结束</translation>
        </message>
        <message>
            <source>end the spline with G5.3</source>
            <translation>用 G5.3 结束样条</translation>
        </message>
        <message>
            <source>feeds are above 0</source>
            <translation>进给速度大于 0</translation>
        </message>
        <message>
            <source>free space or write elsewhere</source>
            <translation>腾出空间，或写到别处</translation>
        </message>
        <message>
            <source>functions are ABS ACOS ASIN ATAN COS EXISTS EXP FIX FUP LN ROUND SIN SQRT TAN</source>
            <translation>函数有 ABS ACOS ASIN ATAN COS EXISTS EXP FIX FUP LN ROUND SIN SQRT TAN</translation>
        </message>
        <message>
            <source>give --am, or an acceleration for each axis that moves</source>
            <translation>给出路径加速度，或每个运动轴的加速度</translation>
        </message>
        <message>
            <source>add [KINS] KINEMATICS, or give each axis its own limits in [AXIS_X] and so on</source>
            <translation>添加 [KINS] KINEMATICS，或在 [AXIS_X] 等节中给出每个轴的限值</translation>
        </message>
        <message>
            <source>give each axis its own limits in [AXIS_X] and so on</source>
            <translation>在 [AXIS_X] 等节中给出每个轴的限值</translation>
        </message>
        <message>
            <source>give --jm, or a jerk for each axis that moves, or choose another law</source>
            <translation>给出路径加加速度，或每个运动轴的加加速度，或选别的规律</translation>
        </message>
        <message>
            <source>give --timer-hz, such as 1000000</source>
            <translation>给出 --timer-hz，如 1000000</translation>
        </message>
        <message>
            <source>give --vmax, a feedrate, or a speed for each axis that moves</source>
            <translation>给出最高速度、进给速度，或每个运动轴的速度</translation>
        </message>
        <message>
            <source>give 0 or more</source>
            <translation>取不小于 0 的值</translation>
        </message>
        <message>
            <source>give F before</source>
            <translation>先给出 F</translation>
        </message>
        <message>
            <source>give F before or in this block</source>
            <translation>在此之前或本段中给出 F</translation>
        </message>
        <message>
            <source>give F in every block with a feed move, or use G94</source>
            <translation>每个进给程序段都写 F，或用 G94</translation>
        </message>
        <message>
            <source>give I and J</source>
            <translation>写出 I 和 J</translation>
        </message>
        <message>
            <source>give I and K</source>
            <translation>写出 I 和 K</translation>
        </message>
        <message>
            <source>give J and K</source>
            <translation>写出 J 和 K</translation>
        </message>
        <message>
            <source>give R, or I J K</source>
            <translation>写出 R，或 I J K</translation>
        </message>
        <message>
            <source>give R, or I J K, not both</source>
            <translation>R 与 I J K 只写一种</translation>
        </message>
        <message>
            <source>give S and M3 or M4 before</source>
            <translation>先给出 S 和 M3 或 M4</translation>
        </message>
        <message>
            <source>give S before</source>
            <translation>先给出 S</translation>
        </message>
        <message>
            <source>give X and Y</source>
            <translation>写出 X 和 Y</translation>
        </message>
        <message>
            <source>give a deeper first cut J</source>
            <translation>第一刀 J 取深一些</translation>
        </message>
        <message>
            <source>give a faster timer or fewer steps per mm</source>
            <translation>用更快的定时器，或减少每毫米步数</translation>
        </message>
        <message>
            <source>give a file with motion in it</source>
            <translation>选一个含有运动的文件</translation>
        </message>
        <message>
            <source>give a full circle by its centre (I J K)</source>
            <translation>整圆请用圆心 (I J K) 给出</translation>
        </message>
        <message>
            <source>give a larger Q</source>
            <translation>把 Q 改大</translation>
        </message>
        <message>
            <source>give %1, or a limit for each axis that moves</source>
            <translation>给出路径限制（%1），或每个运动轴的限制</translation>
        </message>
        <message>
            <source>give a motion code such as G0 or G1</source>
            <translation>写出运动代码，如 G0 或 G1</translation>
        </message>
        <message>
            <source>give a positive F</source>
            <translation>F 取正值</translation>
        </message>
        <message>
            <source>give a slower timer</source>
            <translation>用更慢的定时器</translation>
        </message>
        <message>
            <source>give a smaller count</source>
            <translation>次数取小一些</translation>
        </message>
        <message>
            <source>give an NC program or a CSV polyline, as UTF-8 or an 8-bit text</source>
            <translation>选 NC 程序或 CSV 折线，UTF-8 或 8 位文本</translation>
        </message>
        <message>
            <source>give an end point away from here</source>
            <translation>终点要离开当前点</translation>
        </message>
        <message>
            <source>give at least 1 block, or all</source>
            <translation>至少 1 段，或全部</translation>
        </message>
        <message>
            <source>give at least as many control points as the order</source>
            <translation>控制点数不少于阶数</translation>
        </message>
        <message>
            <source>give at least one axis</source>
            <translation>至少写一个轴</translation>
        </message>
        <message>
            <source>give both, or none to mirror the last handle</source>
            <translation>两个都写，或都不写以对称延续上一个控制柄</translation>
        </message>
        <message>
            <source>give each sub, if, while, do and repeat a label of its own</source>
            <translation>每个 sub、if、while、do 和 repeat 用各自的标号</translation>
        </message>
        <message>
            <source>give fewer different tolerances and limits</source>
            <translation>减少不同公差和限值的个数</translation>
        </message>
        <message>
            <source>give it with P</source>
            <translation>用 P 给出</translation>
        </message>
        <message>
            <source>give it with Q</source>
            <translation>用 Q 给出</translation>
        </message>
        <message>
            <source>give its weight with P</source>
            <translation>用 P 给出权</translation>
        </message>
        <message>
            <source>give the angle with ^</source>
            <translation>用 ^ 给出角度</translation>
        </message>
        <message>
            <source>give the cutting speed with S</source>
            <translation>用 S 给出切削速度</translation>
        </message>
        <message>
            <source>give the depth</source>
            <translation>给出深度</translation>
        </message>
        <message>
            <source>give the depth of a peck with Q</source>
            <translation>用 Q 给出每次啄钻深度</translation>
        </message>
        <message>
            <source>give the diameter with D</source>
            <translation>用 D 给出直径</translation>
        </message>
        <message>
            <source>give the dwell in s with P</source>
            <translation>用 P 给出暂停时间（秒）</translation>
        </message>
        <message>
            <source>give the end point</source>
            <translation>写出终点</translation>
        </message>
        <message>
            <source>give the handle with I and J</source>
            <translation>用 I 和 J 给出控制柄</translation>
        </message>
        <message>
            <source>give the highest speed with D beside G96</source>
            <translation>在 G96 旁用 D 给出最高转速</translation>
        </message>
        <message>
            <source>give the path or every axis that moves an acceleration limit</source>
            <translation>给路径或每个运动轴设加速度限制</translation>
        </message>
        <message>
            <source>give the pitch</source>
            <translation>给出螺距</translation>
        </message>
        <message>
            <source>give the retract level with R</source>
            <translation>用 R 给出退刀平面</translation>
        </message>
        <message>
            <source>give the second handle with P and Q</source>
            <translation>用 P 和 Q 给出第二个控制柄</translation>
        </message>
        <message>
            <source>is it the file of this program?</source>
            <translation>这是本程序的文件吗？</translation>
        </message>
        <message>
            <source>it must be 0 or between 1e-30 and 1e30</source>
            <translation>必须为 0，或在 1e-30 与 1e30 之间</translation>
        </message>
        <message>
            <source>it must be at least 1</source>
            <translation>至少为 1</translation>
        </message>
        <message>
            <source>it must be between 1e-30 and 1e30</source>
            <translation>必须在 1e-30 与 1e30 之间</translation>
        </message>
        <message>
            <source>it must be between 1e-30 and 1e30, or inf for no limit</source>
            <translation>必须在 1e-30 与 1e30 之间，不限制则为 inf</translation>
        </message>
        <message>
            <source>jog and home before the program begins</source>
            <translation>在程序开始之前点动和回零</translation>
        </message>
        <message>
            <source>keep one of them in this block</source>
            <translation>本程序段只保留其中一个</translation>
        </message>
        <message>
            <source>keep one point</source>
            <translation>只保留一个小数点</translation>
        </message>
        <message>
            <source>laws: %1</source>
            <translation>速度规律：%1</translation>
        </message>
        <message>
            <source>leave X out</source>
            <translation>去掉 X</translation>
        </message>
        <message>
            <source>leave compensation on a straight move</source>
            <translation>在直线移动上取消补偿</translation>
        </message>
        <message>
            <source>leave the key out for no limit</source>
            <translation>不限制就去掉这个键</translation>
        </message>
        <message>
            <source>letters outside of ASCII stand in comments and in texts of one line</source>
            <translation>非 ASCII 字符只能写在注释和单行文本中</translation>
        </message>
        <message>
            <source>lines may have %1 bytes; is this an NC program?</source>
            <translation>一行最多 %1 字节；这是 NC 程序吗？</translation>
        </message>
        <message>
            <source>machine files are TOML</source>
            <translation>机床文件是 TOML 格式</translation>
        </message>
        <message>
            <source>move the other axes in a block of their own</source>
            <translation>其他轴在单独的程序段中移动</translation>
        </message>
        <message>
            <source>move the part, or tell with --work-offset where it lies</source>
            <translation>移动工件，或用 --work-offset 给出工件位置</translation>
        </message>
        <message>
            <source>name a file</source>
            <translation>选一个文件</translation>
        </message>
        <message>
            <source>name a file in it</source>
            <translation>选其中的一个文件</translation>
        </message>
        <message>
            <source>name the coordinate system with P</source>
            <translation>用 P 指定坐标系</translation>
        </message>
        <message>
            <source>name the loop around this line</source>
            <translation>写出包含本行的循环的标号</translation>
        </message>
        <message>
            <source>name the macro with P</source>
            <translation>用 P 指定宏程序</translation>
        </message>
        <message>
            <source>name the sub-program with P</source>
            <translation>用 P 指定子程序</translation>
        </message>
        <message>
            <source>name the tool with P</source>
            <translation>用 P 指定刀具</translation>
        </message>
        <message>
            <source>numbers have a decimal point, not a comma</source>
            <translation>数字用小数点，不用逗号</translation>
        </message>
        <message>
            <source>one of %1</source>
            <translation>可选：%1</translation>
        </message>
        <message>
            <source>only calls may compute their label</source>
            <translation>只有 call 的标号可以是计算的</translation>
        </message>
        <message>
            <source>open the spline with G5.2</source>
            <translation>用 G5.2 开始样条</translation>
        </message>
        <message>
            <source>operators are + - * / ** MOD AND OR XOR EQ NE GT GE LT LE</source>
            <translation>运算符有 + - * / ** MOD AND OR XOR EQ NE GT GE LT LE</translation>
        </message>
        <message>
            <source>orders go from 2 to 20</source>
            <translation>阶数为 2 到 20</translation>
        </message>
        <message>
            <source>orientations go from 0 to 9</source>
            <translation>刀尖方位为 0 到 9</translation>
        </message>
        <message>
            <source>parameters go from #1 to #%1</source>
            <translation>参数为 #1 到 #%1</translation>
        </message>
        <message>
            <source>post the program without it</source>
            <translation>后处理时不要输出它</translation>
        </message>
        <message>
            <source>put it in quotes</source>
            <translation>放在引号中</translation>
        </message>
        <message>
            <source>put it on a line of its own</source>
            <translation>单独写一行</translation>
        </message>
        <message>
            <source>put steps_per_mm into [axes.X] of the machine file</source>
            <translation>在机床文件的 [axes.X] 中写 steps_per_mm</translation>
        </message>
        <message>
            <source>put the argument in []</source>
            <translation>把参数写在 [] 中</translation>
        </message>
        <message>
            <source>put them into a block with a motion code</source>
            <translation>写到有运动代码的程序段里</translation>
        </message>
        <message>
            <source>put them into blocks of their own</source>
            <translation>分别写到各自的程序段</translation>
        </message>
        <message>
            <source>raise the feed or lower the speed to it</source>
            <translation>提高进给，或把速度降到它以下</translation>
        </message>
        <message>
            <source>raise the feedrate or the override above 0</source>
            <translation>把进给速度或倍率提高到 0 以上</translation>
        </message>
        <message>
            <source>remove it, or add the code it belongs to</source>
            <translation>去掉它，或加上它所属的代码</translation>
        </message>
        <message>
            <source>remove it, or call the sub-program</source>
            <translation>去掉它，或调用子程序</translation>
        </message>
        <message>
            <source>remove it; numbers have no exponent here: write them out</source>
            <translation>去掉它；这里的数没有指数：请写全</translation>
        </message>
        <message>
            <source>remove one of them</source>
            <translation>去掉其中一个</translation>
        </message>
        <message>
            <source>remove them</source>
            <translation>去掉它们</translation>
        </message>
        <message>
            <source>repeats are a whole number from 0 to 1000000</source>
            <translation>重复次数是 0 到 1000000 的整数</translation>
        </message>
        <message>
            <source>rows may have %1 bytes</source>
            <translation>一行最多 %1 字节</translation>
        </message>
        <message>
            <source>rows need %1 values</source>
            <translation>每行需要 %1 个值</translation>
        </message>
        <message>
            <source>save it as UTF-8</source>
            <translation>存为 UTF-8</translation>
        </message>
        <message>
            <source>save it with M70 in the same program or sub-program</source>
            <translation>在同一程序或子程序中用 M70 保存</translation>
        </message>
        <message>
            <source>see to what the program complains of</source>
            <translation>处理程序所报告的问题</translation>
        </message>
        <message>
            <source>set the rotation with G10 L2</source>
            <translation>用 G10 L2 设置旋转</translation>
        </message>
        <message>
            <source>split the expression</source>
            <translation>拆分表达式</translation>
        </message>
        <message>
            <source>split the spline</source>
            <translation>拆分样条</translation>
        </message>
        <message>
            <source>start cutter radius compensation farther away from the contour</source>
            <translation>在离轮廓更远处开始刀具半径补偿</translation>
        </message>
        <message>
            <source>start it with M3 before G84</source>
            <translation>在 G84 之前用 M3 启动</translation>
        </message>
        <message>
            <source>start it with M3 or M4</source>
            <translation>用 M3 或 M4 启动</translation>
        </message>
        <message>
            <source>start it with M4 before G74</source>
            <translation>在 G74 之前用 M4 启动</translation>
        </message>
        <message>
            <source>sub endsub call return if elseif else endif while endwhile do repeat endrepeat break continue</source>
            <translation>可用：sub endsub call return if elseif else endif while endwhile do repeat endrepeat break continue</translation>
        </message>
        <message>
            <source>take a faster timer clock or a lower top speed</source>
            <translation>用更快的定时器时钟或更低的最高速度</translation>
        </message>
        <message>
            <source>take a slower timer clock or a shorter move</source>
            <translation>用更慢的定时器时钟或更短的移动</translation>
        </message>
        <message>
            <source>take a slower timer clock or shorter ramps</source>
            <translation>用更慢的定时器时钟或更短的加减速段</translation>
        </message>
        <message>
            <source>take an end speed of %1, or a length of at least %2</source>
            <translation>终点速度取 %1，或长度至少为 %2</translation>
        </message>
        <message>
            <source>test the divisor before</source>
            <translation>事先检查除数</translation>
        </message>
        <message>
            <source>the header is t_s,x_mm,y_mm,z_mm[,a_deg,b_deg,c_deg],v_mm_s,a_mm_s2,j_mm_s3,line</source>
            <translation>表头是 t_s,x_mm,y_mm,z_mm[,a_deg,b_deg,c_deg],v_mm_s,a_mm_s2,j_mm_s3,line</translation>
        </message>
        <message>
            <source>the radius must be at least %1 mm</source>
            <translation>半径至少为 %1 mm</translation>
        </message>
        <message>
            <source>this is no text: is the file damaged?</source>
            <translation>这不是文本：文件是否损坏？</translation>
        </message>
        <message>
            <source>tool numbers are whole numbers from 0 to 99999999</source>
            <translation>刀号是 0 到 99999999 的整数</translation>
        </message>
        <message>
            <source>turn it in a block before</source>
            <translation>在前一程序段中转动它</translation>
        </message>
        <message>
            <source>use .csv, .npy, .npz, .halstream or .semicolon.csv</source>
            <translation>用 .csv、.npy、.npz、.halstream 或 .semicolon.csv</translation>
        </message>
        <message>
            <source>use @ ^ or X Y, not both</source>
            <translation>@ ^ 与 X Y 只用一种</translation>
        </message>
        <message>
            <source>use G17</source>
            <translation>用 G17</translation>
        </message>
        <message>
            <source>use G17 or G18</source>
            <translation>用 G17 或 G18</translation>
        </message>
        <message>
            <source>use G18</source>
            <translation>用 G18</translation>
        </message>
        <message>
            <source>use G53 with G0 or G1</source>
            <translation>G53 与 G0 或 G1 一起用</translation>
        </message>
        <message>
            <source>use G90 with G53</source>
            <translation>G53 与 G90 一起用</translation>
        </message>
        <message>
            <source>use G94</source>
            <translation>用 G94</translation>
        </message>
        <message>
            <source>use a smaller tool</source>
            <translation>换用更小的刀具</translation>
        </message>
        <message>
            <source>use a smaller tool or a rounder corner</source>
            <translation>换用更小的刀具，或把拐角改圆</translation>
        </message>
        <message>
            <source>use a whole number behind #</source>
            <translation># 后面用整数</translation>
        </message>
        <message>
            <source>use another name</source>
            <translation>用别的名称</translation>
        </message>
        <message>
            <source>use another parameter</source>
            <translation>用别的参数</translation>
        </message>
        <message>
            <source>use fewer names</source>
            <translation>减少名称的个数</translation>
        </message>
        <message>
            <source>use global parameters</source>
            <translation>用全局参数</translation>
        </message>
        <message>
            <source>words are a letter and a number, such as T1 P1 D6 Z50</source>
            <translation>字由字母和数组成，如 T1 P1 D6 Z50</translation>
        </message>
        <message>
            <source>words begin with a plain letter; comments stand in ( ) or behind ;</source>
            <translation>字以普通字母开头；注释写在 ( ) 中或 ; 之后</translation>
        </message>
        <message>
            <source>write #number = value</source>
            <translation>写成 #号 = 值</translation>
        </message>
        <message>
            <source>write ATAN[y]/[x]</source>
            <translation>写成 ATAN[y]/[x]</translation>
        </message>
        <message>
            <source>write EXISTS[#&lt;name&gt;]</source>
            <translation>写成 EXISTS[#&lt;name&gt;]</translation>
        </message>
        <message>
            <source>write IF [..] GOTO n or IF [..] THEN #n = ..</source>
            <translation>写成 IF [..] GOTO n 或 IF [..] THEN #n = ..</translation>
        </message>
        <message>
            <source>write N and a number from 0</source>
            <translation>写 N 和不小于 0 的数</translation>
        </message>
        <message>
            <source>give each rotary axis once</source>
            <translation>每个旋转轴只列一次</translation>
        </message>
        <message>
            <source>give the length from the spindle's nose to the tip</source>
            <translation>请给出从主轴端面到刀尖的长度</translation>
        </message>
        <message>
            <source>name the rotary axis</source>
            <translation>请写出旋转轴的名称</translation>
        </message>
        <message>
            <source>say whether it carries the workpiece or the spindle</source>
            <translation>请说明它带动工件还是主轴</translation>
        </message>
        <message>
            <source>name a machine file with [kinematics] by --machine</source>
            <translation>用 --machine 指定含有 [kinematics] 的机床文件</translation>
        </message>
        <message>
            <source>turn the farther rotary axis before the tool is tilted, in a block of its own</source>
            <translation>在刀具倾斜之前，用单独的程序段先转动离刀具较远的旋转轴</translation>
        </message>
        <message>
            <source>say whether the rotary axes turn evenly between blocks, or the tool in a plane</source>
            <translation>请指明程序段之间是旋转轴匀速转动 (axes)，还是刀轴在平面内转动 (plane)</translation>
        </message>
        <message>
            <source>retract before, or give the axis more travel</source>
            <translation>请先退刀，或给该轴更大的行程</translation>
        </message>
        <message>
            <source>give the tool&apos;s direction or the axes, not both</source>
            <translation>刀具方向与旋转轴只给其一</translation>
        </message>
        <message>
            <source>give the direction from its tip to the spindle, such as K1</source>
            <translation>给出从刀尖指向主轴的方向，例如 K1</translation>
        </message>
        <message>
            <source>end G43.4 or G43.5 with G49 first</source>
            <translation>请先用 G49 结束 G43.4 或 G43.5</translation>
        </message>
        <message>
            <source>use G43.4 H or G43.5 H, or read the whole program so with --tcp</source>
            <translation>使用 G43.4 H 或 G43.5 H，或用 --tcp 把整个程序按刀尖读取</translation>
        </message>
        <message>
            <source>post the program as G-code with G43.4 H or G43.5 H (Fanuc), or with the tool&apos;s tip in X Y Z throughout, which --tcp reads</source>
            <translation>请把程序后处理为带 G43.4 H 或 G43.5 H 的 G 代码（Fanuc），或 X Y Z 全程为刀尖坐标的 G 代码（用 --tcp 读取）</translation>
        </message>
        <message>
            <source>give a file with that column, such as .csv or .npy</source>
            <translation>请给出带有该列的文件，例如 .csv 或 .npy</translation>
        </message>
        <message>
            <source>--corner blend asks for that at once</source>
            <translation>直接用 --corner blend 即可</translation>
        </message>
        <message>
            <source>add tool_mm to [kinematics]</source>
            <translation>在 [kinematics] 中加入 tool_mm</translation>
        </message>
        <message>
            <source>name it with --machine, or add rotary = [...] to it</source>
            <translation>用 --machine 指定机床文件，或在其中加入 rotary = [...]</translation>
        </message>
        <message>
            <source>write .csv or .semicolon.csv</source>
            <translation>请写 .csv 或 .semicolon.csv</translation>
        </message>
        <message>
            <source>tilt the tool less, or check the directions of the rotary axes in [kinematics]</source>
            <translation>减小刀具倾斜，或检查 [kinematics] 中旋转轴的方向</translation>
        </message>
        <message>
            <source>give the axis more travel, or tilt the tool otherwise</source>
            <translation>增大该轴行程，或改变刀具倾斜</translation>
        </message>
        <message>
            <source>write SETVN 500[NAME,NAME]</source>
            <translation>请写 SETVN 500[NAME,NAME]</translation>
        </message>
        <message>
            <source>write O100 or O&lt;name&gt;</source>
            <translation>写成 O100 或 O&lt;name&gt;</translation>
        </message>
        <message>
            <source>write [%1]</source>
            <translation>写成 [%1]</translation>
        </message>
        <message>
            <source>write [axes.X]</source>
            <translation>写成 [axes.X]</translation>
        </message>
        <message>
            <source>write [condition]</source>
            <translation>写成 [条件]</translation>
        </message>
        <message>
            <source>write [servo] or [servo.X]</source>
            <translation>写成 [servo] 或 [servo.X]</translation>
        </message>
        <message>
            <source>write a name between &lt; and &gt;</source>
            <translation>在 &lt; 与 &gt; 之间写名称</translation>
        </message>
        <message>
            <source>write a number, a #parameter or an expression in []</source>
            <translation>写数字、#参数或 [] 中的表达式</translation>
        </message>
        <message>
            <source>write elsewhere or split the program</source>
            <translation>写到别处，或拆分程序</translation>
        </message>
        <message>
            <source>write it to a file and read that</source>
            <translation>先写入文件再读取</translation>
        </message>
        <message>
            <source>write repeat [count]</source>
            <translation>写成 repeat [次数]</translation>
        </message>
        <message>
            <source>give it in seconds with P</source>
            <translation>用 P 给出秒数</translation>
        </message>
        <message>
            <source>write #1 = value or #&lt;name&gt; = value; comments stand in ( ) or behind ;</source>
            <translation>写成 #1 = 值 或 #&lt;名称&gt; = 值；注释写在 ( ) 内或 ; 之后</translation>
        </message>
        <message>
            <source>D of G96 is above 0, in turns a minute</source>
            <translation>G96 的 D 须大于 0，单位为转/分</translation>
        </message>
        <message>
            <source>select the tool with T, such as T1 M6</source>
            <translation>用 T 选择刀具，例如 T1 M6</translation>
        </message>
        <message>
            <source>use G17, or give X Y Z</source>
            <translation>用 G17，或给出 X Y Z</translation>
        </message>
        <message>
            <source>give the offset, such as Z10</source>
            <translation>给出偏置，例如 Z10</translation>
        </message>
        <message>
            <source>name the tool with H</source>
            <translation>用 H 指定刀具</translation>
        </message>
        <message>
            <source>make the window smaller, or give more memory</source>
            <translation>请缩小窗口，或提供更多内存</translation>
        </message>
        <message>
            <source>save what comes from it as a file and open that</source>
            <translation>请将其内容存成文件，再打开该文件</translation>
        </message>
        <message>
            <source>use one of %1</source>
            <translation>请使用其中之一：%1</translation>
        </message>
        <message>
            <source>correct the controller&apos;s settings</source>
            <translation>改正控制器的设置</translation>
        </message>
        <message>
            <source>send G21, then M503 again</source>
            <translation>先发送 G21，再重新执行 M503</translation>
        </message>
        <message>
            <source>give a gain below %1 1/s, which is 4π·damping·bandwidth</source>
            <translation>增益应低于 %1 1/s，即 4π·阻尼·带宽</translation>
        </message>
        <message>
            <source>give a time of 0 to 1e9 s</source>
            <translation>时间应为 0 到 1e9 s</translation>
        </message>
        <message>
            <source>give it a name in UTF-8 and limits in their ranges</source>
            <translation>名称须为 UTF-8，限值须在允许范围内</translation>
        </message>
        <message>
            <source>leave the key out for its default</source>
            <translation>省略该键即用默认值</translation>
        </message>
        <message>
            <source>save the machine under another name</source>
            <translation>把机床另存为其他名称</translation>
        </message>
        <message>
            <source>the gain must be 1e-3 to 1e5 1/s, bandwidth and resonance 0.01 to 1e5 Hz, damping 1e-3 to 100</source>
            <translation>增益须为 1e-3 到 1e5 1/s，带宽和谐振频率 0.01 到 1e5 Hz，阻尼 1e-3 到 100</translation>
        </message>
        <message>
            <source>$ names the spindle of M3 M4 M5 M19 S G33 G33.1 G76 G96 G97</source>
            <translation>$ 指定 M3 M4 M5 M19 S G33 G33.1 G76 G96 G97 的主轴</translation>
        </message>
        <message>
            <source>P1 to P300 are G54.1 P1 to P300</source>
            <translation>P1 到 P300 即 G54.1 P1 到 P300</translation>
        </message>
        <message>
            <source>check G17 G18 G19; --dialect grbl and others leave the word out</source>
            <translation>请检查 G17 G18 G19；--dialect grbl 等方言会忽略该词</translation>
        </message>
        <message>
            <source>check the centre words I J K, G90.1/G91.1, and the plane; --arc-tolerance-mm lets more pass</source>
            <translation>请检查圆心词 I J K、G90.1/G91.1 和平面；--arc-tolerance-mm 可放宽</translation>
        </message>
        <message>
            <source>check the number of the line</source>
            <translation>请检查行号</translation>
        </message>
        <message>
            <source>corners are made in the plane of G17, G18 or G19 alone</source>
            <translation>拐角只能在 G17、G18 或 G19 的平面内</translation>
        </message>
        <message>
            <source>give P1 to P300</source>
            <translation>请给出 P1 到 P300</translation>
        </message>
        <message>
            <source>give X or U, and Z or W</source>
            <translation>请给出 X 或 U，以及 Z 或 W</translation>
        </message>
        <message>
            <source>give a smaller ,C or ,R</source>
            <translation>请给出更小的 ,C 或 ,R</translation>
        </message>
        <message>
            <source>give it with F</source>
            <translation>请用 F 给出</translation>
        </message>
        <message>
            <source>give the move that the corner leads to in the next block</source>
            <translation>请在下一程序段给出拐角之后的移动</translation>
        </message>
        <message>
            <source>spindles are $0 to $7; $-1 is all of them</source>
            <translation>主轴为 $0 到 $7；$-1 表示全部</translation>
        </message>
        <message>
            <source>remove the %, or begin the program with one, too</source>
            <translation>请删去 %，或在程序开头也写一个</translation>
        </message>
        <message>
            <source>give more decimals; --arc-tolerance-mm decides what is refused</source>
            <translation>请多给几位小数；--arc-tolerance-mm 决定何时拒绝</translation>
        </message>
        <message>
            <source>P and Q are the numbers of the first and the last line of the contour</source>
            <translation>P 和 Q 是轮廓首行和末行的行号</translation>
        </message>
        <message>
            <source>R is a whole number from 1 to 1000</source>
            <translation>R 为 1 到 1000 的整数</translation>
        </message>
        <message>
            <source>a contour has a move to its start, and one along it</source>
            <translation>轮廓包含一个到起点的移动和一个沿轮廓的移动</translation>
        </message>
        <message>
            <source>give a deeper first cut</source>
            <translation>请给出更深的第一刀</translation>
        </message>
        <message>
            <source>give it with D, or with U of a block before (G72: W)</source>
            <translation>请用 D 给出，或在前一程序段用 U（G72 用 W）给出</translation>
        </message>
        <message>
            <source>give larger steps</source>
            <translation>请给出更大的步距</translation>
        </message>
        <message>
            <source>give the height of the thread and the depth of the first cut</source>
            <translation>请给出螺纹牙高和第一刀深度</translation>
        </message>
        <message>
            <source>give their numbers with P and Q</source>
            <translation>请用 P 和 Q 给出行号</translation>
        </message>
        <message>
            <source>in system A it is a cycle: give X and Z</source>
            <translation>在体系 A 中它是循环：请给出 X 和 Z</translation>
        </message>
        <message>
            <source>name the offset with P, give it with R</source>
            <translation>用 P 指定补偿号，用 R 给出数值</translation>
        </message>
        <message>
            <source>put its file beside the program or into a folder given with --sub-path</source>
            <translation>请将其文件放在程序旁边，或放入用 --sub-path 给出的文件夹</translation>
        </message>
        <message>
            <source>use G90, or leave the radius out</source>
            <translation>请用 G90，或不给半径</translation>
        </message>
        <message>
            <source>name the dialect with --dialect: linuxcnc and grbl dwell in s, fanuc and marlin in ms</source>
            <translation>请用 --dialect 指定方言：linuxcnc 和 grbl 以秒计，fanuc 和 marlin 以毫秒计</translation>
        </message>
        <message>
            <source>put them into a block of their own</source>
            <translation>请放进单独的程序段</translation>
        </message>
        <message>
            <source>give a scale of 0.0001 to 10000</source>
            <translation>请给出 0.0001 到 10000 的缩放系数</translation>
        </message>
        <message>
            <source>give the scale with P</source>
            <translation>请用 P 给出缩放系数</translation>
        </message>
        <message>
            <source>write decimal points; --integers lengths reads them as lengths</source>
            <translation>请写小数点；--integers lengths 按长度读取</translation>
        </message>
        <message>
            <source>write decimal points; --integers increments reads them so</source>
            <translation>请写小数点；--integers increments 按最小单位读取</translation>
        </message>
        <message>
            <source>post the program as G-code (RS-274) for LinuxCNC, Fanuc, Haas, Mach3, grbl or Marlin; polylines are read as CSV</source>
            <translation>请后处理为 LinuxCNC、Fanuc、Haas、Mach3、grbl 或 Marlin 的 G 代码（RS-274）；折线按 CSV 读取</translation>
        </message>
        <message>
            <source>write ,C for a chamfer, ,R for a rounding or ,A for the angle of a line; numbers have a decimal point, not a comma</source>
            <translation>倒角写 ,C，倒圆写 ,R，直线的角度写 ,A；数字用小数点，不用逗号</translation>
        </message>
        <message>
            <source>give one of its coordinates, or in the next block both coordinates and an angle</source>
            <translation>请给出它的一个坐标，或在下一程序段中给出两个坐标和角度</translation>
        </message>
        <message>
            <source>check the angle, which counts from the first axis of the plane: Z of lathes, X of mills</source>
            <translation>请检查角度；它从平面的第一轴算起：车床为 Z，铣床为 X</translation>
        </message>
        <message>
            <source>give it with F or E</source>
            <translation>请用 F 或 E 给出</translation>
        </message>
        <message>
            <source>give the cycle before, with L0 where it shall not drill, such as G81 Z-5. R1. F50. L0</source>
            <translation>请先给出固定循环；不钻孔时用 L0，例如 G81 Z-5. R1. F50. L0</translation>
        </message>
        <message>
            <source>G70 I J L: circle; G71 I J K L: arc; G72 I J L: line; I radius or distance, J angle, L holes</source>
            <translation>G70 I J L：圆；G71 I J K L：圆弧；G72 I J L：直线；I 为半径或间距，J 为角度，L 为孔数</translation>
        </message>
        <message>
            <source>scale both axes alike, or give the curve as lines</source>
            <translation>请使两轴缩放相同，或用直线给出曲线</translation>
        </message>
        <message>
            <source>write a decimal point where it is a length</source>
            <translation>若是长度，请写小数点</translation>
        </message>
        <message>
            <source>L is a whole number from 1 to 10000</source>
            <translation>L 是 1 到 10000 的整数</translation>
        </message>
        <message>
            <source>give a tool table with --tools</source>
            <translation>请用 --tools 给出刀具表</translation>
        </message>
        <message>
            <source>--corner servo follows each of them</source>
            <translation>--corner servo 会逐一遵循这些限值</translation>
        </message>
        <message>
            <source>--corner servo follows it</source>
            <translation>--corner servo 会遵循它</translation>
        </message>
        <message>
            <source>check Q and R</source>
            <translation>请检查 Q 和 R</translation>
        </message>
        <message>
            <source>give one above 0</source>
            <translation>请给出大于 0 的值</translation>
        </message>
        <message>
            <source>give fine_acceleration_mm_s2 in [path]</source>
            <translation>请在 [path] 中给出 fine_acceleration_mm_s2</translation>
        </message>
        <message>
            <source>levels go from 1 to %1</source>
            <translation>等级从 1 到 %1</translation>
        </message>
        <message>
            <source>name the variable with P, such as P#100</source>
            <translation>请用 P 指定变量，例如 P#100</translation>
        </message>
        <message>
            <source>give its radius with I; of growing circles the first radius with I, the last with K, the step with Q</source>
            <translation>请用 I 给出半径；逐圈扩大时 I 为第一圈半径，K 为最后一圈半径，Q 为步距</translation>
        </message>
        <message>
            <source>write ,C for a chamfer; the axis C is known by a G0 with it</source>
            <translation>倒角请写 ,C；C 轴由带 C 的 G0 识别</translation>
        </message>
        <message>
            <source>check the angles</source>
            <translation>请检查角度</translation>
        </message>
        <message>
            <source>scale both axes alike</source>
            <translation>请使两轴缩放相同</translation>
        </message>
        <message>
            <source>write G90.1, or G91.1 and distances from the start</source>
            <translation>请写 G90.1，或写 G91.1 并给出到起点的距离</translation>
        </message>
        <message>
            <source>change it in that file</source>
            <translation>请在那个文件中修改</translation>
        </message>
        <message>
            <source>change it in the file by hand</source>
            <translation>请手动在文件中修改</translation>
        </message>
        <message>
            <source>--corner blend or smooth rounds them; --verify tells how far the shaped path is from the program</source>
            <translation>--corner blend 或 smooth 可圆滑拐角；--verify 会给出成形路径偏离程序的距离</translation>
        </message>
        <message>
            <source>leave the mode out if there is none</source>
            <translation>没有该模态就不要写它</translation>
        </message>
        <message>
            <source>write its frequency_hz</source>
            <translation>请写出它的 frequency_hz</translation>
        </message>
        <message>
            <source>write [[servo.X.modes]] with frequency_hz, damping and share</source>
            <translation>请写 [[servo.X.modes]]，其中含 frequency_hz、damping 和 share</translation>
        </message>
        <message>
            <source>record while the axis is shaken or tapped</source>
            <translation>请在轴被激振或敲击时记录</translation>
        </message>
        <message>
            <source>shake less, or give it a larger range</source>
            <translation>请减小激振，或增大量程</translation>
        </message>
        <message>
            <source>shake or tap the axis harder, and record some seconds of it</source>
            <translation>请更用力地激振或敲击该轴，并记录几秒钟</translation>
        </message>
        <message>
            <source>say which is which: --columns t=1,x=2,y=3,z=4, with a unit in brackets: x=2[g]</source>
            <translation>请说明各列含义：--columns t=1,x=2,y=3,z=4，单位写在方括号中：x=2[g]</translation>
        </message>
        <message>
            <source>record some seconds at the rate of the accelerometer</source>
            <translation>请以加速度计的采样率记录几秒钟</translation>
        </message>
        <message>
            <source>record at an even rate, or cut the recording to where it is even</source>
            <translation>请以均匀的采样率记录，或截取均匀的部分</translation>
        </message>
        <message>
            <source>take resonance_hz out of [servo.X] to have it as a mode</source>
            <translation>若要作为模态，请从 [servo.X] 中删去 resonance_hz</translation>
        </message>
    </context>
    <context>
        <name>toolpace::studio::Actions</name>
        <message>
            <source>&amp;Open…</source>
            <translation>打开(&amp;O)…</translation>
        </message>
        <message>
            <source>&amp;Reload</source>
            <translation>重新加载(&amp;R)</translation>
        </message>
        <message>
            <source>Open the e&amp;xample</source>
            <translation>打开示例(&amp;X)</translation>
        </message>
        <message>
            <source>&amp;Quit</source>
            <translation>退出(&amp;Q)</translation>
        </message>
        <message>
            <source>&amp;Setpoints…</source>
            <translation>设定点(&amp;S)…</translation>
        </message>
        <message>
            <source>&amp;Contour preview…</source>
            <translation>轮廓预览(&amp;C)…</translation>
        </message>
        <message>
            <source>&amp;Plots…</source>
            <translation>曲线图(&amp;P)…</translation>
        </message>
        <message>
            <source>&amp;Window…</source>
            <translation>窗口(&amp;W)…</translation>
        </message>
        <message>
            <source>&amp;Open machine…</source>
            <translation>打开机床(&amp;O)…</translation>
        </message>
        <message>
            <source>&amp;Save machine</source>
            <translation>保存机床(&amp;S)</translation>
        </message>
        <message>
            <source>Save machine &amp;as…</source>
            <translation>机床另存为(&amp;A)…</translation>
        </message>
        <message>
            <source>&amp;Default limits</source>
            <translation>默认限值(&amp;D)</translation>
        </message>
        <message>
            <source>&amp;Undo</source>
            <translation>撤销(&amp;U)</translation>
        </message>
        <message>
            <source>&amp;Redo</source>
            <translation>重做(&amp;R)</translation>
        </message>
        <message>
            <source>&amp;Find in program</source>
            <translation>在程序中查找(&amp;F)</translation>
        </message>
        <message>
            <source>&amp;Go to…</source>
            <translation>跳转到…(&amp;G)</translation>
        </message>
        <message>
            <source>&amp;Edit line</source>
            <translation>编辑行(&amp;E)</translation>
        </message>
        <message>
            <source>&amp;Play or pause</source>
            <translation>播放或暂停(&amp;P)</translation>
        </message>
        <message>
            <source>One line &amp;back</source>
            <translation>后退一行(&amp;B)</translation>
        </message>
        <message>
            <source>One line &amp;on</source>
            <translation>前进一行(&amp;O)</translation>
        </message>
        <message>
            <source>To the &amp;start</source>
            <translation>到开头(&amp;S)</translation>
        </message>
        <message>
            <source>To the &amp;end</source>
            <translation>到结尾(&amp;E)</translation>
        </message>
        <message>
            <source>&amp;Cancel</source>
            <translation>取消(&amp;C)</translation>
        </message>
        <message>
            <source>Next p&amp;roblem</source>
            <translation>下一个问题(&amp;R)</translation>
        </message>
        <message>
            <source>Next place that &amp;loses time</source>
            <translation>下一处时间损失(&amp;L)</translation>
        </message>
        <message>
            <source>Pin this plan as &amp;B</source>
            <translation>将当前规划固定为 B(&amp;B)</translation>
        </message>
        <message>
            <source>Let &amp;go of B</source>
            <translation>放开 B(&amp;G)</translation>
        </message>
        <message>
            <source>S&amp;wap A and B</source>
            <translation>交换 A 与 B(&amp;W)</translation>
        </message>
        <message>
            <source>Sweep the look-a&amp;head</source>
            <translation>扫描前瞻深度(&amp;H)</translation>
        </message>
        <message>
            <source>&amp;Fit</source>
            <translation>适合窗口(&amp;F)</translation>
        </message>
        <message>
            <source>View along &amp;Z (XY)</source>
            <translation>沿 &amp;Z 观察 (XY)</translation>
        </message>
        <message>
            <source>View along &amp;Y (XZ)</source>
            <translation>沿 &amp;Y 观察 (XZ)</translation>
        </message>
        <message>
            <source>View along &amp;X (YZ)</source>
            <translation>沿 &amp;X 观察 (YZ)</translation>
        </message>
        <message>
            <source>&amp;Isometric view</source>
            <translation>等轴测视图(&amp;I)</translation>
        </message>
        <message>
            <source>&amp;Dark theme</source>
            <translation>深色主题(&amp;D)</translation>
        </message>
        <message>
            <source>&amp;Touch mode</source>
            <translation>触摸模式(&amp;T)</translation>
        </message>
        <message>
            <source>Show &amp;inches</source>
            <translation>显示英寸(&amp;I)</translation>
        </message>
        <message>
            <source>&amp;Reset the layout</source>
            <translation>重置布局(&amp;R)</translation>
        </message>
        <message>
            <source>&amp;Handbook</source>
            <translation>手册(&amp;H)</translation>
        </message>
        <message>
            <source>&amp;Keys</source>
            <translation>快捷键(&amp;K)</translation>
        </message>
        <message>
            <source>&amp;About Toolpace</source>
            <translation>关于 Toolpace(&amp;A)</translation>
        </message>
        <message>
            <source>Open</source>
            <translation>打开</translation>
        </message>
        <message>
            <source>&amp;Report…</source>
            <translation>报告(&amp;R)…</translation>
        </message>
        <message>
            <source>Report</source>
            <translation>报告</translation>
        </message>
        <message>
            <source>Step p&amp;ulses…</source>
            <translation>步进脉冲(&amp;U)…</translation>
        </message>
        <message>
            <source>Setpoints with v, a, j of each &amp;axis</source>
            <translation>设定点附各轴 v、a、j(&amp;A)</translation>
        </message>
        <message>
            <source>Semicolon files with &amp;decimal comma</source>
            <translation>分号文件用逗号作小数点(&amp;D)</translation>
        </message>
        <message>
            <source>Feed &amp;hold at the cursor</source>
            <translation>在光标处进给保持(&amp;H)</translation>
        </message>
        <message>
            <source>Take the feed h&amp;old away</source>
            <translation>取消进给保持(&amp;O)</translation>
        </message>
        <message>
            <source>&amp;Save</source>
            <translation>保存(&amp;S)</translation>
        </message>
        <message>
            <source>Save &amp;as…</source>
            <translation>另存为(&amp;A)…</translation>
        </message>
        <message>
            <source>&amp;Insert a line</source>
            <translation>插入一行(&amp;I)</translation>
        </message>
        <message>
            <source>&amp;Delete the lines chosen</source>
            <translation>删除所选行(&amp;D)</translation>
        </message>
        <message>
            <source>&amp;Import machine…</source>
            <translation>导入机床(&amp;I)…</translation>
        </message>
        <message>
            <source>View as at a &amp;lathe (ZX)</source>
            <translation>车床视图 (ZX)(&amp;L)</translation>
        </message>
        <message>
            <source>Speeds a &amp;minute</source>
            <translation>速度按每分钟显示(&amp;M)</translation>
        </message>
        <message>
            <source>&amp;Keep the heights of the plots</source>
            <translation>保持图的高度(&amp;K)</translation>
        </message>
        <message>
            <source>Show &amp;rapids</source>
            <translation>显示快移(&amp;R)</translation>
        </message>
        <message>
            <source>&amp;Print…</source>
            <translation>打印(&amp;P)…</translation>
        </message>
        <message>
            <source>&amp;Toolpace&apos;s plan</source>
            <translation>Toolpace 的规划(&amp;T)</translation>
        </message>
        <message>
            <source>A &amp;controller with its settings…</source>
            <translation>控制器及其设置(&amp;C)…</translation>
        </message>
        <message>
            <source>&amp;Save settings</source>
            <translation>保存设置(&amp;S)</translation>
        </message>
        <message>
            <source>Save settings &amp;as…</source>
            <translation>设置另存为(&amp;A)…</translation>
        </message>
        <message>
            <source>What would each setting &amp;give?</source>
            <translation>各项设置能省多少？(&amp;G)</translation>
        </message>
        <message>
            <source>Heights of the plots fit the c&amp;utting</source>
            <translation>曲线高度适应切削(&amp;U)</translation>
        </message>
        <message>
            <source>&amp;Times beside the lines</source>
            <translation>行旁显示用时(&amp;T)</translation>
        </message>
        <message>
            <source>&amp;Program for this controller…</source>
            <translation>适合此控制器的程序(&amp;P)…</translation>
        </message>
        <message>
            <source>Open &amp;trace…</source>
            <translation>打开测量记录(&amp;T)…</translation>
        </message>
        <message>
            <source>C&amp;lose the trace</source>
            <translation>关闭测量记录(&amp;L)</translation>
        </message>
        <message>
            <source>Find the &amp;best settings</source>
            <translation>寻找最佳设置(&amp;B)</translation>
        </message>
        <message>
            <source>Which setting he&amp;lps most?</source>
            <translation>哪项设置最有用(&amp;L)？</translation>
        </message>
    </context>
    <context>
        <name>toolpace::studio::MainWindow</name>
        <message>
            <source>Look-ahead</source>
            <translation>前瞻</translation>
        </message>
        <message>
            <source>Problems</source>
            <translation>问题</translation>
        </message>
        <message>
            <source>default limits</source>
            <translation>默认限值</translation>
        </message>
        <message>
            <source>Machine: %1</source>
            <translation>机床：%1</translation>
        </message>
        <message>
            <source>NC program</source>
            <translation>NC 程序</translation>
        </message>
        <message>
            <source>Motion along the path</source>
            <translation>沿路径的运动</translation>
        </message>
        <message>
            <source>Tuning</source>
            <translation>调试</translation>
        </message>
        <message>
            <source>Result</source>
            <translation>结果</translation>
        </message>
        <message>
            <source>Limits</source>
            <translation>限制</translation>
        </message>
        <message>
            <source>Lines</source>
            <translation>程序行</translation>
        </message>
        <message>
            <source>Depth</source>
            <translation>深度</translation>
        </message>
        <message>
            <source>&amp;File</source>
            <translation>文件(&amp;F)</translation>
        </message>
        <message>
            <source>&amp;Edit</source>
            <translation>编辑(&amp;E)</translation>
        </message>
        <message>
            <source>&amp;Plan</source>
            <translation>规划(&amp;P)</translation>
        </message>
        <message>
            <source>&amp;View</source>
            <translation>视图(&amp;V)</translation>
        </message>
        <message>
            <source>&amp;Help</source>
            <translation>帮助(&amp;H)</translation>
        </message>
        <message>
            <source>Open re&amp;cent</source>
            <translation>最近打开(&amp;C)</translation>
        </message>
        <message>
            <source>&amp;Machine</source>
            <translation>机床(&amp;M)</translation>
        </message>
        <message>
            <source>&amp;Export</source>
            <translation>导出(&amp;E)</translation>
        </message>
        <message>
            <source>&amp;Panels</source>
            <translation>面板(&amp;P)</translation>
        </message>
        <message>
            <source>&amp;Language</source>
            <translation>语言(&amp;L)</translation>
        </message>
        <message>
            <source>Export</source>
            <translation>导出</translation>
        </message>
        <message>
            <source>Save setpoints and pictures</source>
            <translation>保存设定点和图片</translation>
        </message>
        <message>
            <source>Machine file: limits and defaults</source>
            <translation>机床文件：限值与默认值</translation>
        </message>
        <message>
            <source>Machine</source>
            <translation>机床</translation>
        </message>
        <message>
            <source>Switch between millimetres and inches</source>
            <translation>切换毫米与英寸</translation>
        </message>
        <message>
            <source>Tools</source>
            <translation>工具</translation>
        </message>
        <message>
            <source>Open a program</source>
            <translation>打开程序</translation>
        </message>
        <message>
            <source>NC programs (*.ngc *.nc *.tap *.gcode *.g *.cnc *.mpf *.txt);;Polylines (*.csv);;All files (*)</source>
            <translation>NC 程序 (*.ngc *.nc *.tap *.gcode *.g *.cnc *.mpf *.txt);;折线 (*.csv);;所有文件 (*)</translation>
        </message>
        <message>
            <source>Open a machine</source>
            <translation>打开机床</translation>
        </message>
        <message>
            <source>Save the machine</source>
            <translation>保存机床</translation>
        </message>
        <message>
            <source>Machine files (*.toml)</source>
            <translation>机床文件 (*.toml)</translation>
        </message>
        <message>
            <source>saved %1</source>
            <translation>已保存 %1</translation>
        </message>
        <message>
            <source>Save setpoints</source>
            <translation>保存设定点</translation>
        </message>
        <message>
            <source>saved %1 rows to %2</source>
            <translation>已将 %1 行保存到 %2</translation>
        </message>
        <message>
            <source>Picture (*.png)</source>
            <translation>图片 (*.png)</translation>
        </message>
        <message>
            <source>Vector graphic (*.svg)</source>
            <translation>矢量图 (*.svg)</translation>
        </message>
        <message>
            <source>PDF (*.pdf)</source>
            <translation>PDF (*.pdf)</translation>
        </message>
        <message>
            <source>Save a picture</source>
            <translation>保存图片</translation>
        </message>
        <message>
            <source>The handbook is not here. The package toolpace-doc brings it, and scripts/handbook makes it.</source>
            <translation>这里没有手册。软件包 toolpace-doc 带有手册,scripts/handbook 也可以生成。</translation>
        </message>
        <message>
            <source>No browser opened the handbook. It is the page
%1</source>
            <translation>没有浏览器打开手册。它的页面是
%1</translation>
        </message>
        <message>
            <source>Handbook</source>
            <translation>手册</translation>
        </message>
        <message>
            <source>Keys</source>
            <translation>快捷键</translation>
        </message>
        <message>
            <source>About Toolpace</source>
            <translation>关于 Toolpace</translation>
        </message>
        <message>
            <source>Plans the motion of CNC machines.</source>
            <translation>为数控机床规划运动。</translation>
        </message>
        <message>
            <source>nothing opened yet</source>
            <translation>尚未打开过文件</translation>
        </message>
        <message>
            <source>Single move</source>
            <translation>单段运动</translation>
        </message>
        <message>
            <source>Stepper pulses</source>
            <translation>步进脉冲</translation>
        </message>
        <message>
            <source>Save the report</source>
            <translation>保存报告</translation>
        </message>
        <message>
            <source>Web page (*.html)</source>
            <translation>网页 (*.html)</translation>
        </message>
        <message>
            <source>refining…</source>
            <translation>优化中…</translation>
        </message>
        <message>
            <source>planning</source>
            <translation>规划中</translation>
        </message>
        <message>
            <source>stale</source>
            <translation>待更新</translation>
        </message>
        <message>
            <source>The plan shown is not yet the one of these parameters</source>
            <translation>显示的规划尚未按这些参数更新</translation>
        </message>
        <message>
            <source>Shown is a quick plan; a faster motion inside the tolerance is computed</source>
            <translation>当前显示快速规划；正在容差内计算更快的运动</translation>
        </message>
        <message>
            <source>not refined</source>
            <translation>未优化</translation>
        </message>
        <message>
            <source>Shown is the quick plan; reload (F5) to refine it</source>
            <translation>当前显示快速规划；按 F5 重新优化</translation>
        </message>
        <message>
            <source>Feed hold</source>
            <translation>进给保持</translation>
        </message>
        <message>
            <source>Feed hold here, at %1</source>
            <translation>在此处进给保持（%1）</translation>
        </message>
        <message>
            <source>Cursor here</source>
            <translation>光标移到此处</translation>
        </message>
        <message>
            <source>Step pulses</source>
            <translation>步进脉冲</translation>
        </message>
        <message>
            <source>Frequency of the timer in Hz</source>
            <translation>定时器频率（Hz）</translation>
        </message>
        <message>
            <source>Save step pulses</source>
            <translation>保存步进脉冲</translation>
        </message>
        <message>
            <source>saving</source>
            <translation>保存中</translation>
        </message>
        <message>
            <source>Circle</source>
            <translation>圆度</translation>
        </message>
        <message>
            <source>Setpoints &amp;as</source>
            <translation>设定点另存为(&amp;A)</translation>
        </message>
        <message>
            <source>edited</source>
            <translation>已修改</translation>
        </message>
        <message>
            <source>Changes that are not saved</source>
            <translation>尚未保存的修改</translation>
        </message>
        <message>
            <source>Dialect of the program</source>
            <translation>程序的方言</translation>
        </message>
        <message>
            <source>%1 has changes that are not saved.</source>
            <translation>%1 有尚未保存的修改。</translation>
        </message>
        <message>
            <source>Save the program</source>
            <translation>保存程序</translation>
        </message>
        <message>
            <source>%1 was changed by another program and read again</source>
            <translation>%1 已被其他程序更改，并已重新读取</translation>
        </message>
        <message>
            <source>Machine files (*.toml);;LinuxCNC configuration (*.ini);;grbl settings, as $$ lists them (*.txt);;All files (*)</source>
            <translation>机床文件 (*.toml);;LinuxCNC 配置 (*.ini);;grbl 设置（$$ 的输出） (*.txt);;所有文件 (*)</translation>
        </message>
        <message>
            <source>The machine “%1” has changes that are not saved.</source>
            <translation>机床“%1”有尚未保存的更改。</translation>
        </message>
        <message>
            <source>Drives</source>
            <translation>驱动</translation>
        </message>
        <message>
            <source>Reading options</source>
            <translation>读取选项</translation>
        </message>
        <message>
            <source>Prese&amp;ts</source>
            <translation>预设(&amp;T)</translation>
        </message>
        <message>
            <source>Settings of the controller</source>
            <translation>控制器的设置</translation>
        </message>
        <message>
            <source>Import the settings of a controller</source>
            <translation>导入控制器的设置</translation>
        </message>
        <message>
            <source>Settings (*.ini *.txt *.cfg *.nc);;All files (*)</source>
            <translation>设置 (*.ini *.txt *.cfg *.nc);;所有文件 (*)</translation>
        </message>
        <message>
            <source>Copy the lines</source>
            <translation>复制所选行</translation>
        </message>
        <message>
            <source>Copy the results</source>
            <translation>复制结果</translation>
        </message>
        <message>
            <source>Switch between speeds a second and a minute</source>
            <translation>切换每秒与每分钟的速度</translation>
        </message>
        <message>
            <source>Spectrum and speeds</source>
            <translation>频谱与速度</translation>
        </message>
        <message>
            <source>the printer takes nothing</source>
            <translation>打印机无法使用</translation>
        </message>
        <message>
            <source>Controller</source>
            <translation>控制器</translation>
        </message>
        <message>
            <source>R&amp;uns on</source>
            <translation>运行于(&amp;U)</translation>
        </message>
        <message>
            <source>Runs on</source>
            <translation>运行于</translation>
        </message>
        <message>
            <source>Toolpace&apos;s plan, or a controller with its settings file</source>
            <translation>Toolpace 的规划，或某个控制器及其设置文件</translation>
        </message>
        <message>
            <source>Settings (*.ini *.txt *.cfg *.nc *.gcode *.log);;All files (*)</source>
            <translation>设置 (*.ini *.txt *.cfg *.nc *.gcode *.log);;所有文件 (*)</translation>
        </message>
        <message>
            <source>Setting %1</source>
            <translation>设置 %1</translation>
        </message>
        <message>
            <source>The settings “%1” have changes that are not saved.</source>
            <translation>设置“%1”有未保存的更改。</translation>
        </message>
        <message>
            <source>Save the settings</source>
            <translation>保存设置</translation>
        </message>
        <message>
            <source>All files (*)</source>
            <translation>所有文件 (*)</translation>
        </message>
        <message>
            <source>Runs on %1</source>
            <translation>运行于 %1</translation>
        </message>
        <message>
            <source>Save the program for the controller</source>
            <translation>保存适合控制器的程序</translation>
        </message>
        <message>
            <source>NC programs (*.ngc *.nc *.tap *.gcode *.g *.cnc *.mpf *.txt)</source>
            <translation>NC 程序 (*.ngc *.nc *.tap *.gcode *.g *.cnc *.mpf *.txt)</translation>
        </message>
        <message>
            <source>Trace</source>
            <translation>测量记录</translation>
        </message>
        <message>
            <source>Tune</source>
            <translation>调优</translation>
        </message>
        <message>
            <source>Open a trace</source>
            <translation>打开测量记录</translation>
        </message>
        <message>
            <source>Traces (*.csv *.txt *.tsv *.dat *.log);;All files (*)</source>
            <translation>测量记录 (*.csv *.txt *.tsv *.dat *.log);;所有文件 (*)</translation>
        </message>
    </context>
    <context>
        <name>toolpace::studio::Report</name>
        <message>
            <source>Proof</source>
            <translation>验证</translation>
        </message>
        <message>
            <source>%1 setpoints were read back and keep every limit.</source>
            <translation>已回读 %1 个设定点，全部满足限值。</translation>
        </message>
        <message>
            <source>Contour</source>
            <translation>轮廓</translation>
        </message>
        <message>
            <source>Motion</source>
            <translation>运动</translation>
        </message>
        <message>
            <source>Machine and options</source>
            <translation>机床与选项</translation>
        </message>
    </context>
    <context>
        <name>toolpace::ui::AxesGrid</name>
        <message>
            <source>top speed</source>
            <translation>最高速度</translation>
        </message>
        <message>
            <source>acceleration limit</source>
            <translation>加速度限值</translation>
        </message>
        <message>
            <source>jerk limit</source>
            <translation>加加速度限值</translation>
        </message>
        <message>
            <source>Axis %1, %2</source>
            <translation>%1 轴，%2</translation>
        </message>
        <message>
            <source>%1; empty = no limit</source>
            <translation>%1；留空表示无限制</translation>
        </message>
        <message>
            <source>Axis</source>
            <translation>轴</translation>
        </message>
    </context>
    <context>
        <name>toolpace::ui::ContourCanvas</name>
        <message>
            <source>Contour preview</source>
            <translation>轮廓预览</translation>
        </message>
        <message>
            <source>line %1</source>
            <translation>第 %1 行</translation>
        </message>
        <message>
            <source>drop an NC program here</source>
            <translation>将 NC 程序拖放到这里</translation>
        </message>
        <message>
            <source>held by: %1</source>
            <translation>受限于：%1</translation>
        </message>
    </context>
    <context>
        <name>toolpace::ui::ContourLegend</name>
        <message>
            <source>Legend of the contour preview</source>
            <translation>轮廓预览图例</translation>
        </message>
    </context>
    <context>
        <name>toolpace::ui::ContourView</name>
        <message>
            <source>Contour</source>
            <translation>轮廓</translation>
        </message>
        <message>
            <source>Contour preview</source>
            <translation>轮廓预览</translation>
        </message>
        <message>
            <source>Legend of the contour preview</source>
            <translation>轮廓预览图例</translation>
        </message>
        <message>
            <source>Colour by</source>
            <translation>着色依据</translation>
        </message>
        <message>
            <source>What the colours of the path show</source>
            <translation>路径颜色的含义</translation>
        </message>
        <message>
            <source>Colour map</source>
            <translation>色图</translation>
        </message>
        <message>
            <source>Colour map; all are safe for colour-blind eyes</source>
            <translation>色图；均适合色觉异常者</translation>
        </message>
        <message>
            <source>Error enlargement</source>
            <translation>误差放大</translation>
        </message>
        <message>
            <source>cividis</source>
            <translation>cividis</translation>
        </message>
        <message>
            <source>viridis</source>
            <translation>viridis</translation>
        </message>
        <message>
            <source>turbo</source>
            <translation>turbo</translation>
        </message>
        <message>
            <source>XY</source>
            <translation>XY</translation>
        </message>
        <message>
            <source>Look from above (Z)</source>
            <translation>俯视 (Z)</translation>
        </message>
        <message>
            <source>XZ</source>
            <translation>XZ</translation>
        </message>
        <message>
            <source>Look from the front (Y)</source>
            <translation>前视 (Y)</translation>
        </message>
        <message>
            <source>YZ</source>
            <translation>YZ</translation>
        </message>
        <message>
            <source>Look from the right (X)</source>
            <translation>右视 (X)</translation>
        </message>
        <message>
            <source>Iso</source>
            <translation>轴测</translation>
        </message>
        <message>
            <source>Isometric view (I)</source>
            <translation>等轴测视图 (I)</translation>
        </message>
        <message>
            <source>Fit</source>
            <translation>适合</translation>
        </message>
        <message>
            <source>Show the whole path (F)</source>
            <translation>显示整个路径 (F)</translation>
        </message>
        <message>
            <source>How much contour error and tolerance band are enlarged</source>
            <translation>轮廓误差与公差带的放大倍数</translation>
        </message>
        <message>
            <source>Band</source>
            <translation>公差带</translation>
        </message>
        <message>
            <source>Tolerance band</source>
            <translation>公差带</translation>
        </message>
        <message>
            <source>Programmed path, tolerance band, and the plan inside it; off: the simulated drives</source>
            <translation>编程路径、公差带及其中的规划路径；关闭时显示仿真驱动</translation>
        </message>
        <message>
            <source>ZX</source>
            <translation>ZX</translation>
        </message>
        <message>
            <source>As at a lathe: Z to the right, X upwards (L)</source>
            <translation>车床视图：Z 向右，X 向上 (L)</translation>
        </message>
        <message>
            <source>Values with a sign have colours of their own: grey is zero</source>
            <translation>有正负的量有自己的颜色：灰色为零</translation>
        </message>
        <message>
            <source>Limits have colours of their own</source>
            <translation>各限制有自己的颜色</translation>
        </message>
        <message>
            <source>rapids</source>
            <translation>快移</translation>
        </message>
        <message>
            <source>Lines of the preview</source>
            <translation>预览中的线</translation>
        </message>
        <message>
            <source>drives</source>
            <translation>驱动</translation>
        </message>
        <message>
            <source>Dashed: rapids, and the plan that is pinned as B. Red: where the simulated drives go, enlarged</source>
            <translation>虚线：快移，以及固定为 B 的规划。红色：放大后的仿真驱动轨迹</translation>
        </message>
        <message>
            <source>measured</source>
            <translation>实测</translation>
        </message>
    </context>
    <context>
        <name>toolpace::ui::LimitRibbon</name>
        <message>
            <source>limit</source>
            <translation>限制</translation>
        </message>
        <message>
            <source>%1: %2 to %3 s</source>
            <translation>%1：%2 至 %3 s</translation>
        </message>
        <message>
            <source>%1 %2 %</source>
            <translation>%1 %2 %</translation>
        </message>
    </context>
    <context>
        <name>toolpace::ui::LookaheadField</name>
        <message>
            <source>all</source>
            <translation>全部</translation>
        </message>
        <message>
            <source>Look ahead over the whole program</source>
            <translation>前瞻整个程序</translation>
        </message>
        <message>
            <source>Look-ahead depth in blocks, logarithmic; the right end is the whole program</source>
            <translation>前瞻深度（程序段数，对数刻度）；最右端为整个程序</translation>
        </message>
        <message>
            <source>Look-ahead depth</source>
            <translation>前瞻深度</translation>
        </message>
        <message>
            <source>Look-ahead depth in blocks</source>
            <translation>前瞻深度（程序段数）</translation>
        </message>
        <message>
            <source>Look-ahead depth in blocks; 1 stops at every node</source>
            <translation>前瞻深度（程序段数）；1 表示每个节点都停</translation>
        </message>
    </context>
    <context>
        <name>toolpace::ui::LossModel</name>
        <message>
            <source>Line</source>
            <translation>行</translation>
        </message>
        <message>
            <source>Feed</source>
            <translation>进给</translation>
        </message>
        <message>
            <source>Mean</source>
            <translation>平均</translation>
        </message>
        <message>
            <source>Time</source>
            <translation>时间</translation>
        </message>
        <message>
            <source>Loss</source>
            <translation>损失</translation>
        </message>
    </context>
    <context>
        <name>toolpace::ui::LossPanel</name>
        <message>
            <source>Time lost by each NC line</source>
            <translation>各 NC 行损失的时间</translation>
        </message>
        <message>
            <source>%1 s (%2 %) more than at the programmed feed all along, %3</source>
            <translation>比全程按编程进给多用 %1 s（%2 %），%3</translation>
        </message>
        <message>
            <source>on one line</source>
            <translation>在 1 行上</translation>
        </message>
        <message>
            <source>on %1 lines</source>
            <translation>在 %1 行上</translation>
        </message>
    </context>
    <context>
        <name>toolpace::ui::MovePlot</name>
        <message>
            <source>v</source>
            <translation>v</translation>
        </message>
        <message>
            <source>a</source>
            <translation>a</translation>
        </message>
        <message>
            <source>j</source>
            <translation>j</translation>
        </message>
        <message>
            <source>s</source>
            <translation>s</translation>
        </message>
        <message>
            <source>t</source>
            <translation>t</translation>
        </message>
        <message>
            <source>Speed, acceleration, jerk and distance of the move over time</source>
            <translation>运动的速度、加速度、加加速度和位移随时间变化</translation>
        </message>
        <message>
            <source>The numbers above are the durations of the phases</source>
            <translation>上方数字为各阶段的时长</translation>
        </message>
    </context>
    <context>
        <name>toolpace::ui::NcPanel</name>
        <message>
            <source>Find</source>
            <translation>查找</translation>
        </message>
        <message>
            <source>Find in program</source>
            <translation>在程序中查找</translation>
        </message>
        <message>
            <source>120, N120 or 12.5 s</source>
            <translation>120、N120 或 12.5 s</translation>
        </message>
        <message>
            <source>Go to a line, a block number or a time</source>
            <translation>跳转到行、程序段号或时间</translation>
        </message>
        <message>
            <source>not found</source>
            <translation>未找到</translation>
        </message>
        <message>
            <source>NC program</source>
            <translation>NC 程序</translation>
        </message>
        <message>
            <source>drop an NC program here</source>
            <translation>将 NC 程序拖放到这里</translation>
        </message>
        <message>
            <source>mean speed</source>
            <translation>平均速度</translation>
        </message>
        <message>
            <source>time lost</source>
            <translation>损失时间</translation>
        </message>
        <message>
            <source>Bars beside the lines</source>
            <translation>行旁的条</translation>
        </message>
        <message>
            <source>Colour: mean speed of the line, as in the preview; bar: how much longer it takes than at its feed</source>
            <translation>颜色：该行平均速度，与预览相同；条：比按进给多用的时间</translation>
        </message>
        <message>
            <source>times: s on %1</source>
            <translation>用时：在 %1 上的秒数</translation>
        </message>
        <message>
            <source>times: s</source>
            <translation>用时：秒</translation>
        </message>
    </context>
    <context>
        <name>toolpace::ui::NcView</name>
        <message>
            <source>NC program</source>
            <translation>NC 程序</translation>
        </message>
        <message>
            <source>mean %1, programmed %2</source>
            <translation>平均 %1，编程 %2</translation>
        </message>
        <message>
            <source>%1 s, of which %2 s lost</source>
            <translation>%1 s，其中损失 %2 s</translation>
        </message>
        <message>
            <source>Text of line %1</source>
            <translation>第 %1 行文本</translation>
        </message>
        <message>
            <source>rests for %1 s</source>
            <translation>停留 %1 s</translation>
        </message>
        <message>
            <source>from %1 on</source>
            <translation>从 %1 开始</translation>
        </message>
        <message>
            <source>%1 s on the controller</source>
            <translation>在控制器上 %1 s</translation>
        </message>
    </context>
    <context>
        <name>toolpace::ui::NumberField</name>
        <message>
            <source>at least %1 %2</source>
            <translation>至少 %1 %2</translation>
        </message>
        <message>
            <source>%1 to %2 %3</source>
            <translation>%1 至 %2 %3</translation>
        </message>
        <message>
            <source>Not a number</source>
            <translation>不是数字</translation>
        </message>
        <message>
            <source>Must be %1</source>
            <translation>必须为%1</translation>
        </message>
    </context>
    <context>
        <name>toolpace::ui::OverviewStrip</name>
        <message>
            <source>all</source>
            <translation>全部</translation>
        </message>
    </context>
    <context>
        <name>toolpace::ui::ProblemModel</name>
        <message>
            <source>Line</source>
            <translation>行</translation>
        </message>
        <message>
            <source>Message</source>
            <translation>信息</translation>
        </message>
    </context>
    <context>
        <name>toolpace::ui::ProblemsPanel</name>
        <message>
            <source>No errors, no warnings</source>
            <translation>没有错误和警告</translation>
        </message>
        <message>
            <source>Errors and warnings</source>
            <translation>错误和警告</translation>
        </message>
    </context>
    <context>
        <name>toolpace::ui::ProfilePlot</name>
        <message>
            <source>t  s</source>
            <translation>t  s</translation>
        </message>
        <message>
            <source>jerk is not bounded: acceleration changes in steps</source>
            <translation>加加速度无界：加速度呈阶跃变化</translation>
        </message>
        <message>
            <source>B: jerk is not bounded</source>
            <translation>B：加加速度无界</translation>
        </message>
    </context>
    <context>
        <name>toolpace::ui::ProfileView</name>
        <message>
            <source>Visible values</source>
            <translation>可见数值</translation>
        </message>
        <message>
            <source>The visible values as a table; Ctrl+C copies them</source>
            <translation>以表格显示可见数值；Ctrl+C 复制</translation>
        </message>
        <message>
            <source>Table</source>
            <translation>表格</translation>
        </message>
        <message>
            <source>Contour error of the simulated drives as a fourth plot</source>
            <translation>以第四幅图显示驱动仿真的轮廓误差</translation>
        </message>
        <message>
            <source>Contour error</source>
            <translation>轮廓误差</translation>
        </message>
        <message>
            <source>Error</source>
            <translation>误差</translation>
        </message>
        <message>
            <source>Motion</source>
            <translation>运动</translation>
        </message>
        <message>
            <source>Speed, acceleration and jerk over time</source>
            <translation>速度、加速度和加加速度随时间变化</translation>
        </message>
        <message>
            <source>What holds the speed down over time</source>
            <translation>速度受限原因随时间变化</translation>
        </message>
        <message>
            <source>Speed over the whole program, with the visible time</source>
            <translation>整个程序的速度及可见时段</translation>
        </message>
        <message>
            <source>Values at the cursor</source>
            <translation>光标处的值</translation>
        </message>
        <message>
            <source>Show axis %1</source>
            <translation>显示 %1 轴</translation>
        </message>
        <message>
            <source>Measure</source>
            <translation>测量</translation>
        </message>
        <message>
            <source>Two cursors with their differences (M)</source>
            <translation>两个光标及其差值 (M)</translation>
        </message>
        <message>
            <source>Fit</source>
            <translation>适合</translation>
        </message>
        <message>
            <source>Fit time</source>
            <translation>适合时间</translation>
        </message>
        <message>
            <source>Show the whole program</source>
            <translation>显示整个程序</translation>
        </message>
        <message>
            <source>allowed</source>
            <translation>允许值</translation>
        </message>
        <message>
            <source>Lines of the plots</source>
            <translation>图中的线</translation>
        </message>
        <message>
            <source>feed</source>
            <translation>进给</translation>
        </message>
        <message>
            <source>A: this plan, B: the one that is pinned. Dashed grey: what feed, machine and curves allow in each block; pale: the programmed feed</source>
            <translation>A：当前规划，B：固定的规划。灰色虚线：进给、机床和曲率在各段允许的值；浅色：编程进给</translation>
        </message>
        <message>
            <source>Following</source>
            <translation>跟随</translation>
        </message>
        <message>
            <source>Following error</source>
            <translation>跟随误差</translation>
        </message>
        <message>
            <source>Following error of each axis of the trace as a plot of its own</source>
            <translation>以单独的曲线图显示测量记录中各轴的跟随误差</translation>
        </message>
        <message>
            <source>measured</source>
            <translation>实测</translation>
        </message>
        <message>
            <source>Vibration</source>
            <translation>振动</translation>
        </message>
        <message>
            <source>How far each axis with modes swings, as a plot of its own</source>
            <translation>以单独的曲线图显示各有模态的轴的振动位移</translation>
        </message>
    </context>
    <context>
        <name>toolpace::ui::ResultModel</name>
        <message>
            <source>Cycle time</source>
            <translation>循环时间</translation>
        </message>
        <message>
            <source>· cutting</source>
            <translation>· 切削</translation>
        </message>
        <message>
            <source>· rapid</source>
            <translation>· 快移</translation>
        </message>
        <message>
            <source>· dwell</source>
            <translation>· 暂停</translation>
        </message>
        <message>
            <source>Mean speed</source>
            <translation>平均速度</translation>
        </message>
        <message>
            <source>Peak jerk</source>
            <translation>峰值加加速度</translation>
        </message>
        <message>
            <source>Peak speed, rotary</source>
            <translation>峰值速度（回转）</translation>
        </message>
        <message>
            <source>Peak accel., rotary</source>
            <translation>峰值加速度（回转）</translation>
        </message>
        <message>
            <source>Peak jerk, rotary</source>
            <translation>峰值加加速度（回转）</translation>
        </message>
        <message>
            <source>Path length</source>
            <translation>路径长度</translation>
        </message>
        <message>
            <source>Blocks</source>
            <translation>程序段</translation>
        </message>
        <message>
            <source>A</source>
            <translation>A</translation>
        </message>
        <message>
            <source>B</source>
            <translation>B</translation>
        </message>
        <message>
            <source>Violations</source>
            <translation>超限</translation>
        </message>
        <message>
            <source>Contour error</source>
            <translation>轮廓误差</translation>
        </message>
        <message>
            <source>Chord error</source>
            <translation>弦误差</translation>
        </message>
        <message>
            <source>Peak speed</source>
            <translation>峰值速度</translation>
        </message>
        <message>
            <source>Peak accel.</source>
            <translation>峰值加速度</translation>
        </message>
        <message>
            <source>Lower bound</source>
            <translation>时间下界</translation>
        </message>
        <message>
            <source>· plan above it</source>
            <translation>· 超出下界</translation>
        </message>
        <message>
            <source>Off the path</source>
            <translation>偏离路径</translation>
        </message>
        <message>
            <source>Time in rapid moves: G0</source>
            <translation>快移所用时间：G0</translation>
        </message>
        <message>
            <source>Time at rest: G4, tool changes</source>
            <translation>静止时间：G4、换刀</translation>
        </message>
        <message>
            <source>Cycle time / lower bound − 1: what a better plan could save at most</source>
            <translation>循环时间 / 下界 − 1：更好的规划最多能省多少</translation>
        </message>
        <message>
            <source>Where A, B or C move alone</source>
            <translation>仅 A、B 或 C 移动处</translation>
        </message>
        <message>
            <source>Largest v = ds/dt along the path</source>
            <translation>沿路径最大 v = ds/dt</translation>
        </message>
        <message>
            <source>Largest |a| = |dv/dt| along the path</source>
            <translation>沿路径最大 |a| = |dv/dt|</translation>
        </message>
        <message>
            <source>· in rapids</source>
            <translation>· 快移时</translation>
        </message>
        <message>
            <source>The same while the tool does not cut</source>
            <translation>不切削时的同一数值</translation>
        </message>
        <message>
            <source>How far the straight lines between setpoints cut off the planned motion, about (v·Ts)²/8r on an arc</source>
            <translation>设定点之间的直线偏离规划运动多少，圆弧上约 (v·Ts)²/8r</translation>
        </message>
        <message>
            <source>Motion blocks of the program</source>
            <translation>程序的运动段数</translation>
        </message>
        <message>
            <source>Not checked before it was pinned</source>
            <translation>固定之前没有检查</translation>
        </message>
        <message>
            <source>Still being computed</source>
            <translation>仍在计算</translation>
        </message>
        <message>
            <source>More than %1 setpoints: only where you ask for it</source>
            <translation>超过 %1 个设定点：仅在要求时计算</translation>
        </message>
        <message>
            <source>The check was stopped</source>
            <translation>检查已停止</translation>
        </message>
        <message>
            <source>There is no such figure for this plan</source>
            <translation>此规划没有这个数值</translation>
        </message>
        <message>
            <source>Settings that differ</source>
            <translation>不同的设置</translation>
        </message>
        <message>
            <source>What decides plans A and B, where it is not the same</source>
            <translation>决定规划 A 与 B 而又不同的设置</translation>
        </message>
        <message>
            <source>A %1 · B %2</source>
            <translation>A %1 · B %2</translation>
        </message>
        <message>
            <source>From the first move to the last, dwells and tool changes included: T = Σ Δt</source>
            <translation>从第一个到最后一个动作，含暂停和换刀：T = Σ Δt</translation>
        </message>
        <message>
            <source>Time in moves with a feed: G1, G2, G3, splines; Σ Δt of these</source>
            <translation>有进给的动作所用时间：G1、G2、G3、样条；其 Σ Δt</translation>
        </message>
        <message>
            <source>No plan that keeps these limits and this tolerance is faster than this: T ≥ bound</source>
            <translation>遵守这些限制和公差的规划都不会比这更快：T ≥ 下限</translation>
        </message>
        <message>
            <source>Limits that the setpoints break, found by an independent check of them: |Δx/Δt| &gt; v and so on</source>
            <translation>独立检查发现设定点超出的限制：|Δx/Δt| &gt; v 等</translation>
        </message>
        <message>
            <source>Cutting: largest distance of the simulated drives from the commanded path, max |actual − path|; being late is left out</source>
            <translation>切削时仿真驱动偏离指令路径的最大距离，max |实际 − 路径|；滞后不计</translation>
        </message>
        <message>
            <source>Largest distance of the setpoints from the programmed path, as the check measures it: max |setpoint − path|</source>
            <translation>设定点偏离编程路径的最大距离，由检查测得：max |设定点 − 路径|</translation>
        </message>
        <message>
            <source>As it is run, rapids included: s = ∫ v dt</source>
            <translation>按实际运行，含快移：s = ∫ v dt</translation>
        </message>
        <message>
            <source>Path length / cycle time: s / T</source>
            <translation>路径长度 / 循环时间：s / T</translation>
        </message>
        <message>
            <source>Largest |j| = |da/dt| along the path; ∞: acceleration changes in steps</source>
            <translation>沿路径的最大 |j| = |da/dt|；∞：加速度呈阶跃变化</translation>
        </message>
    </context>
    <context>
        <name>toolpace::ui::ResultsPanel</name>
        <message>
            <source>Results of plans A and B</source>
            <translation>规划 A 与 B 的结果</translation>
        </message>
        <message>
            <source>Pin this plan as B</source>
            <translation>将当前规划固定为 B</translation>
        </message>
        <message>
            <source>Swap A and B</source>
            <translation>交换 A 与 B</translation>
        </message>
        <message>
            <source>Let go of B</source>
            <translation>放开 B</translation>
        </message>
        <message>
            <source>Cycle time of plan A</source>
            <translation>规划 A 的循环时间</translation>
        </message>
        <message>
            <source>checking…</source>
            <translation>检查中…</translation>
        </message>
        <message>
            <source>Not checked: more than %1 setpoints</source>
            <translation>未检查：超过 %1 个设定点</translation>
        </message>
        <message>
            <source>Not checked</source>
            <translation>未检查</translation>
        </message>
        <message>
            <source>Stop</source>
            <translation>停止</translation>
        </message>
        <message>
            <source>Check now</source>
            <translation>立即检查</translation>
        </message>
        <message>
            <source>Leave the plan unchecked</source>
            <translation>不检查此规划</translation>
        </message>
        <message>
            <source>Check every limit at the setpoints, and simulate the drives</source>
            <translation>在设定点检查每个限制，并仿真驱动</translation>
        </message>
        <message>
            <source>The controller&apos;s time is not known: see Problems</source>
            <translation>控制器用时未知：见“问题”</translation>
        </message>
        <message>
            <source>predicting…</source>
            <translation>正在预测…</translation>
        </message>
    </context>
    <context>
        <name>toolpace::ui::SingleMovePage</name>
        <message>
            <source>The feed is reached.</source>
            <translation>达到进给速度。</translation>
        </message>
        <message>
            <source>The feed is not reached.</source>
            <translation>未达到进给速度。</translation>
        </message>
        <message>
            <source>L</source>
            <translation>L</translation>
        </message>
        <message>
            <source>F</source>
            <translation>F</translation>
        </message>
        <message>
            <source>fs</source>
            <translation>fs</translation>
        </message>
        <message>
            <source>fe</source>
            <translation>fe</translation>
        </message>
        <message>
            <source>Tacc</source>
            <translation>Tacc</translation>
        </message>
        <message>
            <source>Tdec</source>
            <translation>Tdec</translation>
        </message>
        <message>
            <source>A</source>
            <translation>A</translation>
        </message>
        <message>
            <source>D</source>
            <translation>D</translation>
        </message>
        <message>
            <source>J</source>
            <translation>J</translation>
        </message>
        <message>
            <source>J dec</source>
            <translation>J 减速</translation>
        </message>
        <message>
            <source>Length</source>
            <translation>长度</translation>
        </message>
        <message>
            <source>Feed</source>
            <translation>进给</translation>
        </message>
        <message>
            <source>Start speed</source>
            <translation>起始速度</translation>
        </message>
        <message>
            <source>End speed</source>
            <translation>终止速度</translation>
        </message>
        <message>
            <source>Acceleration time</source>
            <translation>加速时间</translation>
        </message>
        <message>
            <source>Deceleration time</source>
            <translation>减速时间</translation>
        </message>
        <message>
            <source>Acceleration limit</source>
            <translation>加速度限值</translation>
        </message>
        <message>
            <source>Deceleration limit</source>
            <translation>减速度限值</translation>
        </message>
        <message>
            <source>Jerk limit</source>
            <translation>加加速度限值</translation>
        </message>
        <message>
            <source>Jerk limit while slowing down</source>
            <translation>减速时加加速度限值</translation>
        </message>
        <message>
            <source>peak speed</source>
            <translation>峰值速度</translation>
        </message>
        <message>
            <source>length speeding up</source>
            <translation>加速段长度</translation>
        </message>
        <message>
            <source>length slowing down</source>
            <translation>减速段长度</translation>
        </message>
        <message>
            <source>time speeding up</source>
            <translation>加速时间</translation>
        </message>
        <message>
            <source>time at the peak</source>
            <translation>匀速时间</translation>
        </message>
        <message>
            <source>time slowing down</source>
            <translation>减速时间</translation>
        </message>
        <message>
            <source>total time</source>
            <translation>总时间</translation>
        </message>
        <message>
            <source>jerk speeding up</source>
            <translation>加速段加加速度</translation>
        </message>
        <message>
            <source>jerk slowing down</source>
            <translation>减速段加加速度</translation>
        </message>
        <message>
            <source>peak acceleration</source>
            <translation>峰值加速度</translation>
        </message>
        <message>
            <source>peak deceleration</source>
            <translation>峰值减速度</translation>
        </message>
        <message>
            <source>Preset</source>
            <translation>预设</translation>
        </message>
        <message>
            <source>Fill the form with a known move</source>
            <translation>用已知运动填写表单</translation>
        </message>
        <message>
            <source>own values</source>
            <translation>自定义</translation>
        </message>
        <message>
            <source>Zheng, move 1 (feed reached)</source>
            <translation>Zheng 运动 1（达到进给）</translation>
        </message>
        <message>
            <source>Zheng, move 2 (feed not reached)</source>
            <translation>Zheng 运动 2（未达到进给）</translation>
        </message>
        <message>
            <source>S-curve from rest to rest</source>
            <translation>静止到静止的 S 曲线</translation>
        </message>
        <message>
            <source>Quintic, 20 to 40 mm/s</source>
            <translation>五次多项式，20 至 40 mm/s</translation>
        </message>
        <message>
            <source>Law</source>
            <translation>速度规律</translation>
        </message>
        <message>
            <source>Velocity law</source>
            <translation>速度规律</translation>
        </message>
        <message>
            <source>Units</source>
            <translation>单位</translation>
        </message>
        <message>
            <source>Names of the units; the numbers stay as they are</source>
            <translation>单位名称；数值不变</translation>
        </message>
        <message>
            <source>mm, s</source>
            <translation>mm, s</translation>
        </message>
        <message>
            <source>pulse, cycle</source>
            <translation>脉冲, 周期</translation>
        </message>
    </context>
    <context>
        <name>toolpace::ui::StepperPage</name>
        <message>
            <source>steps</source>
            <translation>步</translation>
        </message>
        <message>
            <source>step/s</source>
            <translation>步/s</translation>
        </message>
        <message>
            <source>The top speed is reached.</source>
            <translation>达到最高速度。</translation>
        </message>
        <message>
            <source>The top speed is not reached.</source>
            <translation>未达到最高速度。</translation>
        </message>
        <message>
            <source>Export the pulse table</source>
            <translation>导出脉冲表</translation>
        </message>
        <message>
            <source>Comma-separated (*.csv);;C header (*.h)</source>
            <translation>逗号分隔 (*.csv);;C 头文件 (*.h)</translation>
        </message>
        <message>
            <source>Written: %1</source>
            <translation>已写入：%1</translation>
        </message>
        <message>
            <source>Steps</source>
            <translation>步数</translation>
        </message>
        <message>
            <source>Top speed</source>
            <translation>最高速度</translation>
        </message>
        <message>
            <source>Tacc</source>
            <translation>Tacc</translation>
        </message>
        <message>
            <source>Tdec</source>
            <translation>Tdec</translation>
        </message>
        <message>
            <source>Timer clock</source>
            <translation>定时器时钟</translation>
        </message>
        <message>
            <source>Number of steps</source>
            <translation>步数</translation>
        </message>
        <message>
            <source>Acceleration time</source>
            <translation>加速时间</translation>
        </message>
        <message>
            <source>Deceleration time</source>
            <translation>减速时间</translation>
        </message>
        <message>
            <source>peak rate</source>
            <translation>峰值频率</translation>
        </message>
        <message>
            <source>total time</source>
            <translation>总时间</translation>
        </message>
        <message>
            <source>total ticks</source>
            <translation>总计数</translation>
        </message>
        <message>
            <source>first interval</source>
            <translation>首个间隔</translation>
        </message>
        <message>
            <source>shortest interval</source>
            <translation>最短间隔</translation>
        </message>
        <message>
            <source>last interval</source>
            <translation>末个间隔</translation>
        </message>
        <message>
            <source>s</source>
            <translation>s</translation>
        </message>
        <message>
            <source>ticks</source>
            <translation>计数</translation>
        </message>
        <message>
            <source>Export…</source>
            <translation>导出…</translation>
        </message>
        <message>
            <source>Write the intervals as CSV or as a C header</source>
            <translation>将间隔写成 CSV 或 C 头文件</translation>
        </message>
        <message>
            <source>Cancel</source>
            <translation>取消</translation>
        </message>
        <message>
            <source>Stop the export</source>
            <translation>停止导出</translation>
        </message>
        <message>
            <source>Progress of the export</source>
            <translation>导出进度</translation>
        </message>
    </context>
    <context>
        <name>toolpace::ui::PulsePlot</name>
        <message>
            <source>step rate  step/s</source>
            <translation>步频  步/s</translation>
        </message>
        <message>
            <source>interval  ticks</source>
            <translation>间隔  计数</translation>
        </message>
        <message>
            <source>pulse number</source>
            <translation>脉冲序号</translation>
        </message>
        <message>
            <source>Step rate and pulse interval over the pulse number</source>
            <translation>步频和脉冲间隔随脉冲序号变化</translation>
        </message>
    </context>
    <context>
        <name>toolpace::ui::SweepPanel</name>
        <message>
            <source>planning… %1 %</source>
            <translation>规划中… %1 %</translation>
        </message>
        <message>
            <source>all</source>
            <translation>全部</translation>
        </message>
        <message>
            <source>Cycle time over look-ahead depth</source>
            <translation>循环时间与前瞻深度</translation>
        </message>
        <message>
            <source>N = %1 comes within 0.5 % of all: %2</source>
            <translation>N = %1 时与全程前瞻相差不到 0.5 %：%2</translation>
        </message>
        <message>
            <source>Only the whole program will do: %1</source>
            <translation>只有前瞻整个程序才行：%1</translation>
        </message>
        <message>
            <source>Sweep</source>
            <translation>扫描</translation>
        </message>
        <message>
            <source>Plan with every look-ahead depth</source>
            <translation>用各个前瞻深度规划</translation>
        </message>
        <message>
            <source>Click on a point to take its depth</source>
            <translation>单击某点以采用其深度</translation>
        </message>
        <message>
            <source>look-ahead  blocks</source>
            <translation>前瞻  程序段</translation>
        </message>
        <message>
            <source>cycle time  s</source>
            <translation>循环时间  s</translation>
        </message>
    </context>
    <context>
        <name>toolpace::ui::TransportBar</name>
        <message>
            <source>To the start</source>
            <translation>到开头</translation>
        </message>
        <message>
            <source>One line back</source>
            <translation>后退一行</translation>
        </message>
        <message>
            <source>Pause</source>
            <translation>暂停</translation>
        </message>
        <message>
            <source>Play</source>
            <translation>播放</translation>
        </message>
        <message>
            <source>Space</source>
            <translation>空格</translation>
        </message>
        <message>
            <source>One line on</source>
            <translation>前进一行</translation>
        </message>
        <message>
            <source>To the end</source>
            <translation>到结尾</translation>
        </message>
        <message>
            <source>Playback speed</source>
            <translation>播放速度</translation>
        </message>
        <message>
            <source>Cancel</source>
            <translation>取消</translation>
        </message>
        <message>
            <source>Progress</source>
            <translation>进度</translation>
        </message>
    </context>
    <context>
        <name>toolpace::ui::TuningPanel</name>
        <message>
            <source>The motion through the tolerance has no use for it</source>
            <translation>在公差内平滑的运动不使用此项</translation>
        </message>
        <message>
            <source>Axis limit</source>
            <translation>轴限值</translation>
        </message>
        <message>
            <source>Law</source>
            <translation>速度规律</translation>
        </message>
        <message>
            <source>Acceleration time</source>
            <translation>加速时间</translation>
        </message>
        <message>
            <source>Deceleration time</source>
            <translation>减速时间</translation>
        </message>
        <message>
            <source>Acceleration along the path</source>
            <translation>沿路径加速度</translation>
        </message>
        <message>
            <source>Deceleration along the path</source>
            <translation>沿路径减速度</translation>
        </message>
        <message>
            <source>Jerk along the path, speeding up</source>
            <translation>沿路径加加速度（加速时）</translation>
        </message>
        <message>
            <source>Jerk along the path, slowing down</source>
            <translation>沿路径加加速度（减速时）</translation>
        </message>
        <message>
            <source>Top speed along the path</source>
            <translation>沿路径最高速度</translation>
        </message>
        <message>
            <source>Interpolation period</source>
            <translation>插补周期</translation>
        </message>
        <message>
            <source>Look-ahead</source>
            <translation>前瞻</translation>
        </message>
        <message>
            <source>Ramps</source>
            <translation>加减速</translation>
        </message>
        <message>
            <source>Corner rule</source>
            <translation>拐角规则</translation>
        </message>
        <message>
            <source>Junction deviation</source>
            <translation>拐角偏差</translation>
        </message>
        <message>
            <source>Feed override</source>
            <translation>进给倍率</translation>
        </message>
        <message>
            <source>Rapid override</source>
            <translation>快移倍率</translation>
        </message>
        <message>
            <source>Velocity law</source>
            <translation>速度规律</translation>
        </message>
        <message>
            <source>Corners</source>
            <translation>拐角</translation>
        </message>
        <message>
            <source>Feed</source>
            <translation>进给</translation>
        </message>
        <message>
            <source>Rapid</source>
            <translation>快移</translation>
        </message>
        <message>
            <source>Feed hold at; empty = none</source>
            <translation>进给保持时刻；空 = 无</translation>
        </message>
        <message>
            <source>Hold</source>
            <translation>保持</translation>
        </message>
        <message>
            <source>Tolerance of rounded corners</source>
            <translation>拐角圆滑公差</translation>
        </message>
        <message>
            <source>Toler.</source>
            <translation>公差</translation>
        </message>
        <message>
            <source>Tuning</source>
            <translation>调试</translation>
        </message>
        <message>
            <source>This law has no use for it</source>
            <translation>此规律不使用它</translation>
        </message>
        <message>
            <source>G64 P of the program rules: %1</source>
            <translation>程序的 G64 P 有效：%1</translation>
        </message>
        <message>
            <source>G64 P of the program rules in %1 of %2 blocks: %3</source>
            <translation>程序的 G64 P 在 %2 段中的 %1 段有效：%3</translation>
        </message>
        <message>
            <source>The tolerance of the job holds where the program names none</source>
            <translation>程序没有给出公差的地方使用作业的公差</translation>
        </message>
        <message>
            <source>G64 P of the program rules in every block</source>
            <translation>程序的 G64 P 在每一段都有效</translation>
        </message>
    </context>
    <context>
        <name>toolpace::ui::Workspace</name>
        <message>
            <source>Swap A and B</source>
            <translation>交换 A 与 B</translation>
        </message>
        <message>
            <source>Feed hold</source>
            <translation>进给保持</translation>
        </message>
        <message>
            <source>Runs on Toolpace&apos;s plan</source>
            <translation>按 Toolpace 的规划运行</translation>
        </message>
    </context>
    <context>
        <name>Tube</name>
        <message>
            <source>band ±%1 %2, used up to %3 %</source>
            <translation>公差带 ±%1 %2，最多用到 %3 %</translation>
        </message>
        <message>
            <source>%1 of %2 %3 tolerance (%4 %)</source>
            <translation>偏差 %1，公差 %2 %3（%4 %）</translation>
        </message>
    </context>
    <context>
        <name>toolpace::ui::CirclePanel</name>
        <message>
            <source>line %1 · R %2 · %3°</source>
            <translation>第 %1 行 · R %2 · %3°</translation>
        </message>
        <message>
            <source>at %1°</source>
            <translation>在 %1°</translation>
        </message>
        <message>
            <source>radius %1 %2 · circular deviation %3 %2 · ×%4</source>
            <translation>半径 %1 %2 · 圆度偏差 %3 %2 · ×%4</translation>
        </message>
        <message>
            <source>with run-in and run-out</source>
            <translation>含切入与切出</translation>
        </message>
        <message>
            <source>most %1   ·   least %2</source>
            <translation>最大 %1   ·   最小 %2</translation>
        </message>
        <message>
            <source>Circle before</source>
            <translation>上一个圆</translation>
        </message>
        <message>
            <source>Next circle</source>
            <translation>下一个圆</translation>
        </message>
        <message>
            <source>Enlargement of the radial error</source>
            <translation>径向误差放大倍数</translation>
        </message>
        <message>
            <source>auto</source>
            <translation>自动</translation>
        </message>
        <message>
            <source>Radial error of the simulated drives over the angle</source>
            <translation>仿真驱动的径向误差随角度的变化</translation>
        </message>
        <message>
            <source>Click on the curve to go there</source>
            <translation>单击曲线跳到该处</translation>
        </message>
        <message>
            <source>no arc in this program, or not simulated yet</source>
            <translation>程序中没有圆弧，或尚未仿真</translation>
        </message>
        <message>
            <source>Circular deviation</source>
            <translation>圆度偏差</translation>
        </message>
    </context>
    <context>
        <name>toolpace::ui::ModalStrip</name>
        <message>
            <source>Motion</source>
            <translation>运动</translation>
        </message>
        <message>
            <source>Plane</source>
            <translation>平面</translation>
        </message>
        <message>
            <source>Units</source>
            <translation>单位</translation>
        </message>
        <message>
            <source>Distances</source>
            <translation>坐标方式</translation>
        </message>
        <message>
            <source>Feed mode</source>
            <translation>进给方式</translation>
        </message>
        <message>
            <source>Work offset</source>
            <translation>工件坐标系</translation>
        </message>
        <message>
            <source>Path control</source>
            <translation>路径控制</translation>
        </message>
        <message>
            <source>Arc centres</source>
            <translation>圆心方式</translation>
        </message>
        <message>
            <source>Cutter compensation</source>
            <translation>刀具半径补偿</translation>
        </message>
        <message>
            <source>Tool length</source>
            <translation>刀具长度</translation>
        </message>
        <message>
            <source>Spindle mode</source>
            <translation>主轴方式</translation>
        </message>
        <message>
            <source>Return of cycles</source>
            <translation>循环返回</translation>
        </message>
        <message>
            <source>Lathe</source>
            <translation>车床</translation>
        </message>
        <message>
            <source>rapid</source>
            <translation>快移</translation>
        </message>
        <message>
            <source>straight, at the feed</source>
            <translation>直线进给</translation>
        </message>
        <message>
            <source>arc, clockwise</source>
            <translation>顺时针圆弧</translation>
        </message>
        <message>
            <source>arc, counter-clockwise</source>
            <translation>逆时针圆弧</translation>
        </message>
        <message>
            <source>inches</source>
            <translation>英寸</translation>
        </message>
        <message>
            <source>millimetres</source>
            <translation>毫米</translation>
        </message>
        <message>
            <source>off</source>
            <translation>关闭</translation>
        </message>
        <message>
            <source>left of the path</source>
            <translation>路径左侧</translation>
        </message>
        <message>
            <source>right of the path</source>
            <translation>路径右侧</translation>
        </message>
        <message>
            <source>no offset</source>
            <translation>无补偿</translation>
        </message>
        <message>
            <source>exact path</source>
            <translation>精确路径</translation>
        </message>
        <message>
            <source>exact stop</source>
            <translation>精确停止</translation>
        </message>
        <message>
            <source>continuous</source>
            <translation>连续</translation>
        </message>
        <message>
            <source>none</source>
            <translation>无</translation>
        </message>
        <message>
            <source>absolute</source>
            <translation>绝对</translation>
        </message>
        <message>
            <source>incremental</source>
            <translation>增量</translation>
        </message>
        <message>
            <source>inverse time</source>
            <translation>反比时间</translation>
        </message>
        <message>
            <source>per minute</source>
            <translation>每分钟</translation>
        </message>
        <message>
            <source>per revolution</source>
            <translation>每转</translation>
        </message>
        <message>
            <source>constant surface speed</source>
            <translation>恒线速</translation>
        </message>
        <message>
            <source>revolutions per minute</source>
            <translation>每分钟转数</translation>
        </message>
        <message>
            <source>to the first height</source>
            <translation>回到初始高度</translation>
        </message>
        <message>
            <source>to the plane R</source>
            <translation>回到 R 平面</translation>
        </message>
        <message>
            <source>Modal state at the cursor line</source>
            <translation>光标行的模态</translation>
        </message>
    </context>
    <context>
        <name>toolpace::studio::Ask</name>
        <message>
            <source>They are lost unless you save them.</source>
            <translation>不保存就会丢失。</translation>
        </message>
        <message>
            <source>Save</source>
            <translation>保存</translation>
        </message>
        <message>
            <source>Don&apos;t save</source>
            <translation>不保存</translation>
        </message>
        <message>
            <source>Cancel</source>
            <translation>取消</translation>
        </message>
        <message>
            <source>%1 was changed by another program.</source>
            <translation>%1 已被其他程序修改。</translation>
        </message>
        <message>
            <source>Saving replaces what that program wrote.</source>
            <translation>保存将覆盖该程序写入的内容。</translation>
        </message>
        <message>
            <source>Replace</source>
            <translation>覆盖</translation>
        </message>
    </context>
    <context>
        <name>toolpace::ui::ChangeBar</name>
        <message>
            <source>Your changes are not saved. Reading the file again puts them aside.</source>
            <translation>您的修改尚未保存。重新读取文件会撇开这些修改。</translation>
        </message>
        <message>
            <source>The file was changed by another program, and your changes are not saved.</source>
            <translation>文件已被其他程序修改，而您的修改尚未保存。</translation>
        </message>
        <message>
            <source>Keep mine</source>
            <translation>保留我的</translation>
        </message>
        <message>
            <source>Stay with the text in the window; saving it replaces the file</source>
            <translation>保留窗口中的文本；保存时将覆盖文件</translation>
        </message>
        <message>
            <source>Take the file&apos;s</source>
            <translation>采用文件的</translation>
        </message>
        <message>
            <source>Read the file again; undo brings your changes back</source>
            <translation>重新读取文件；撤销可恢复您的修改</translation>
        </message>
        <message>
            <source>The machine file was changed by another program, and your changes are not saved.</source>
            <translation>机床文件已被其他程序更改，而您的更改尚未保存。</translation>
        </message>
        <message>
            <source>Stay with the values in the window; saving puts them into the file</source>
            <translation>保留窗口中的值；保存时写入文件</translation>
        </message>
        <message>
            <source>The settings file was changed by another program, and your changes are not saved.</source>
            <translation>设置文件被其他程序更改，而您的更改尚未保存。</translation>
        </message>
    </context>
    <context>
        <name>toolpace::ui::ProgramModel</name>
        <message>
            <source>Reload</source>
            <translation>重新加载</translation>
        </message>
        <message>
            <source>Edit line %1</source>
            <translation>编辑第 %1 行</translation>
        </message>
        <message>
            <source>Insert line %1</source>
            <translation>插入第 %1 行</translation>
        </message>
        <message>
            <source>Delete line %1</source>
            <translation>删除第 %1 行</translation>
        </message>
        <message>
            <source>Delete lines %1 to %2</source>
            <translation>删除第 %1 至 %2 行</translation>
        </message>
    </context>
    <context>
        <name>toolpace::studio::MachineFile</name>
        <message>
            <source>Open machine</source>
            <translation>打开机床</translation>
        </message>
        <message>
            <source>Default limits</source>
            <translation>默认限值</translation>
        </message>
        <message>
            <source>Machine file changed</source>
            <translation>机床文件已更改</translation>
        </message>
    </context>
    <context>
        <name>formats</name>
        <message>
            <source>Comma-separated</source>
            <translation>逗号分隔</translation>
        </message>
        <message>
            <source>NumPy array</source>
            <translation>NumPy 数组</translation>
        </message>
        <message>
            <source>NumPy archive</source>
            <translation>NumPy 归档</translation>
        </message>
        <message>
            <source>LinuxCNC halstreamer</source>
            <translation>LinuxCNC halstreamer</translation>
        </message>
        <message>
            <source>Semicolons</source>
            <translation>分号分隔</translation>
        </message>
    </context>
    <context>
        <name>laws</name>
        <message>
            <source>Trapezoid</source>
            <translation>梯形</translation>
        </message>
        <message>
            <source>Five-phase by time</source>
            <translation>五段（按时间）</translation>
        </message>
        <message>
            <source>Five-phase by jerk</source>
            <translation>五段（按加加速度）</translation>
        </message>
        <message>
            <source>Seven-phase</source>
            <translation>七段</translation>
        </message>
        <message>
            <source>Quintic</source>
            <translation>五次多项式</translation>
        </message>
        <message>
            <source>Time-optimal</source>
            <translation>时间最优</translation>
        </message>
    </context>
    <context>
        <name>PlanPresets</name>
        <message>
            <source>Zheng 2014</source>
            <translation>Zheng 2014</translation>
        </message>
        <message>
            <source>Five-phase ramps of fixed times inside their blocks</source>
            <translation>固定时间的五段加减速，在程序段内完成</translation>
        </message>
        <message>
            <source>Ning 2014, N = 8</source>
            <translation>Ning 2014，N = 8</translation>
        </message>
        <message>
            <source>Quintic ramps inside their blocks, look-ahead over eight of them</source>
            <translation>五次多项式加减速，在程序段内完成，前瞻八段</translation>
        </message>
        <message>
            <source>Fastest on the path</source>
            <translation>路径上最快</translation>
        </message>
        <message>
            <source>Time-optimal ramps across blocks; every corner stays as it is</source>
            <translation>时间最优、跨程序段加减速；拐角保持原样</translation>
        </message>
        <message>
            <source>Fastest inside the tolerance</source>
            <translation>公差内最快</translation>
        </message>
        <message>
            <source>The fastest motion that stays within the tolerance of the path</source>
            <translation>不超出路径公差的最快运动</translation>
        </message>
    </context>
    <context>
        <name>ProblemAction</name>
        <message>
            <source>Tool table…</source>
            <translation>刀具表…</translation>
        </message>
        <message>
            <source>Parameters…</source>
            <translation>参数…</translation>
        </message>
        <message>
            <source>Folder…</source>
            <translation>文件夹…</translation>
        </message>
        <message>
            <source>Arc tolerance…</source>
            <translation>圆弧公差…</translation>
        </message>
        <message>
            <source>Machine…</source>
            <translation>机床…</translation>
        </message>
    </context>
    <context>
        <name>toolpace::studio::ImportDialog</name>
        <message>
            <source>Setting</source>
            <translation>设置</translation>
        </message>
        <message>
            <source>Taken</source>
            <translation>采用值</translation>
        </message>
        <message>
            <source>What is taken</source>
            <translation>采用的内容</translation>
        </message>
        <message>
            <source>not there: no limit</source>
            <translation>没有：不限制</translation>
        </message>
        <message>
            <source>Import machine</source>
            <translation>导入机床</translation>
        </message>
        <message>
            <source>What Toolpace takes from %1:</source>
            <translation>Toolpace 从 %1 采用：</translation>
        </message>
        <message>
            <source>Nothing in it was doubtful.</source>
            <translation>其中没有疑问。</translation>
        </message>
        <message>
            <source>Use this machine</source>
            <translation>使用此机床</translation>
        </message>
        <message>
            <source>Cancel</source>
            <translation>取消</translation>
        </message>
    </context>
    <context>
        <name>toolpace::ui::DockTitle</name>
        <message>
            <source>Put the panel back into the window</source>
            <translation>把面板放回窗口</translation>
        </message>
        <message>
            <source>Close the panel</source>
            <translation>关闭面板</translation>
        </message>
    </context>
    <context>
        <name>toolpace::ui::CalmPanel</name>
        <message>
            <source>Vibration</source>
            <translation>振动</translation>
        </message>
        <message>
            <source>Five-phase ramps</source>
            <translation>五段式斜坡</translation>
        </message>
        <message>
            <source>Seven-phase ramps</source>
            <translation>七段式斜坡</translation>
        </message>
        <message>
            <source>Quintic ramps</source>
            <translation>五次多项式斜坡</translation>
        </message>
        <message>
            <source>Shaper %1</source>
            <translation>整形器 %1</translation>
        </message>
        <message>
            <source>As it is</source>
            <translation>现状</translation>
        </message>
        <message>
            <source>Shaper</source>
            <translation>整形器</translation>
        </message>
        <message>
            <source>planning… %1 %</source>
            <translation>规划中… %1 %</translation>
        </message>
        <message>
            <source>No axis has a mode: give a resonance above, or read them from an accelerometer with toolpace identify</source>
            <translation>没有轴设有模态：请在上方给出共振频率，或用 toolpace identify 从加速度计数据读取</translation>
        </message>
        <message>
            <source>Cancel</source>
            <translation>取消</translation>
        </message>
        <message>
            <source>What helps</source>
            <translation>怎样改善</translation>
        </message>
        <message>
            <source>Plan with the ramp times and jerks that suit the modes, and with each shaper, and measure what is left</source>
            <translation>用与模态相配的斜坡时间和加加速度以及每种整形器分别规划，并测量残余振动</translation>
        </message>
        <message>
            <source>What each way of keeping calm leaves after stops, and what it costs</source>
            <translation>每种减振方法在停止后残余多少振动、代价多少</translation>
        </message>
        <message>
            <source>Now %1 after stops.</source>
            <translation>现在停止后为 %1。</translation>
        </message>
        <message>
            <source>Double click or Enter takes one.</source>
            <translation>双击或按 Enter 采用。</translation>
        </message>
        <message>
            <source>Keeping calm</source>
            <translation>减振</translation>
        </message>
        <message>
            <source>Setpoints become means of planned ones, so that every mode of every axis comes to rest; corners and curves are rounded</source>
            <translation>设定点取规划点的加权平均，使每个轴的每个模态都能静止；拐角和曲线会被圆滑</translation>
        </message>
        <message>
            <source>Residual ≤</source>
            <translation>残余振动 ≤</translation>
        </message>
        <message>
            <source>least</source>
            <translation>最小</translation>
        </message>
        <message>
            <source>Largest residual</source>
            <translation>最大残余振动</translation>
        </message>
        <message>
            <source>What a stop may leave of a vibration; empty: as little as can be</source>
            <translation>停止后允许残余的振动；空：尽可能小</translation>
        </message>
        <message>
            <source>By</source>
            <translation>方法</translation>
        </message>
        <message>
            <source>Leaves</source>
            <translation>残余</translation>
        </message>
        <message>
            <source>Costs</source>
            <translation>代价</translation>
        </message>
        <message>
            <source>What keeps the machine calm, what it leaves and costs</source>
            <translation>减振方法、残余振动与代价</translation>
        </message>
        <message>
            <source>Double click or Enter takes one</source>
            <translation>双击或按 Enter 采用</translation>
        </message>
    </context>
    <context>
        <name>toolpace::ui::DrivesPage</name>
        <message>
            <source>Kv</source>
            <translation>Kv</translation>
        </message>
        <message>
            <source>Gain of the position loop: the lag is about v / Kv</source>
            <translation>位置环增益：滞后约为 v / Kv</translation>
        </message>
        <message>
            <source>Velocity feed-forward</source>
            <translation>速度前馈</translation>
        </message>
        <message>
            <source>Share of the commanded speed that is passed on: the lag is (1 − kv) v / Kv</source>
            <translation>指令速度直接传给驱动的比例：滞后为 (1 − kv) v / Kv</translation>
        </message>
        <message>
            <source>Acceleration feed-forward</source>
            <translation>加速度前馈</translation>
        </message>
        <message>
            <source>Share of the drive&apos;s lag at constant acceleration that is made up</source>
            <translation>恒加速时驱动滞后被补偿的比例</translation>
        </message>
        <message>
            <source>Bandwidth</source>
            <translation>带宽</translation>
        </message>
        <message>
            <source>Natural frequency of the velocity loop</source>
            <translation>速度环的固有频率</translation>
        </message>
        <message>
            <source>Damping</source>
            <translation>阻尼</translation>
        </message>
        <message>
            <source>Of the velocity loop; 0.7 overshoots hardly at all</source>
            <translation>速度环阻尼；0.7 时几乎无超调</translation>
        </message>
        <message>
            <source>Backlash</source>
            <translation>反向间隙</translation>
        </message>
        <message>
            <source>Full play between motor and slide</source>
            <translation>电机与滑台之间的全部间隙</translation>
        </message>
        <message>
            <source>Resonance</source>
            <translation>谐振</translation>
        </message>
        <message>
            <source>First natural frequency of the slide on its drive; 0 = stiff</source>
            <translation>滑台在驱动上的一阶固有频率；0 = 刚性</translation>
        </message>
        <message>
            <source>Its damping</source>
            <translation>谐振阻尼</translation>
        </message>
        <message>
            <source>Damping of the resonance; 0.05 is usual for steel</source>
            <translation>谐振的阻尼；钢结构通常为 0.05</translation>
        </message>
        <message>
            <source>Drive</source>
            <translation>驱动</translation>
        </message>
        <message>
            <source>Contour error: …</source>
            <translation>轮廓误差：…</translation>
        </message>
        <message>
            <source>No plan</source>
            <translation>没有规划</translation>
        </message>
        <message>
            <source>Contour error: %1 cutting, %2 in rapids</source>
            <translation>轮廓误差：切削 %1，快移 %2</translation>
        </message>
        <message>
            <source>Drives</source>
            <translation>驱动</translation>
        </message>
        <message>
            <source>Drive of %1, %2</source>
            <translation>%1 轴驱动，%2</translation>
        </message>
    </context>
    <context>
        <name>toolpace::ui::ReadingPage</name>
        <message>
            <source>Choose the tool table</source>
            <translation>选择刀具表</translation>
        </message>
        <message>
            <source>Choose the parameter file</source>
            <translation>选择参数文件</translation>
        </message>
        <message>
            <source>Choose a folder with sub-programs</source>
            <translation>选择子程序文件夹</translation>
        </message>
        <message>
            <source>Reading the program</source>
            <translation>读取程序</translation>
        </message>
        <message>
            <source>Dialect</source>
            <translation>方言</translation>
        </message>
        <message>
            <source>Whose way of writing programs this is</source>
            <translation>程序按哪种控制器的写法</translation>
        </message>
        <message>
            <source>as the text suggests</source>
            <translation>按文本判断</translation>
        </message>
        <message>
            <source>Without a point</source>
            <translation>无小数点</translation>
        </message>
        <message>
            <source>What X100 means on controllers of Fanuc&apos;s kind</source>
            <translation>在 Fanuc 类控制器上 X100 的含义</translation>
        </message>
        <message>
            <source>X100 is 100 mm</source>
            <translation>X100 为 100 mm</translation>
        </message>
        <message>
            <source>X100 is 0.1 mm</source>
            <translation>X100 为 0.1 mm</translation>
        </message>
        <message>
            <source>Arc tolerance</source>
            <translation>圆弧公差</translation>
        </message>
        <message>
            <source>How far an arc may end off its radius; empty = as the dialect has it</source>
            <translation>圆弧终点允许偏离半径多少；空 = 按方言</translation>
        </message>
        <message>
            <source>dialect</source>
            <translation>方言</translation>
        </message>
        <message>
            <source>Tool table</source>
            <translation>刀具表</translation>
        </message>
        <message>
            <source>As LinuxCNC writes it; empty = none</source>
            <translation>LinuxCNC 格式；空 = 无</translation>
        </message>
        <message>
            <source>Parameters</source>
            <translation>参数</translation>
        </message>
        <message>
            <source>Numbered parameters, as LinuxCNC writes them</source>
            <translation>编号参数，LinuxCNC 格式</translation>
        </message>
        <message>
            <source>Choose: %1</source>
            <translation>选择：%1</translation>
        </message>
        <message>
            <source>Sub-programs</source>
            <translation>子程序</translation>
        </message>
        <message>
            <source>Folders that are searched besides the program&apos;s own</source>
            <translation>除程序所在文件夹外还要查找的文件夹</translation>
        </message>
        <message>
            <source>Add a folder…</source>
            <translation>添加文件夹…</translation>
        </message>
        <message>
            <source>Remove</source>
            <translation>移除</translation>
        </message>
        <message>
            <source>Remove the folder</source>
            <translation>移除文件夹</translation>
        </message>
        <message>
            <source>Skip lines that begin with /</source>
            <translation>跳过以 / 开头的行</translation>
        </message>
        <message>
            <source>Take every warning for an error</source>
            <translation>把警告都当作错误</translation>
        </message>
    </context>
    <context>
        <name>toolpace::ui::WelcomeBar</name>
        <message>
            <source>An example. Try:</source>
            <translation>这是示例。试试：</translation>
        </message>
        <message>
            <source>Less jerk</source>
            <translation>减小加加速度</translation>
        </message>
        <message>
            <source>Put the cursor into the jerk limit: the arrow keys change it, and all follows</source>
            <translation>把光标放进加加速度限制：用方向键改变它，一切随之更新</translation>
        </message>
        <message>
            <source>Rounded corners</source>
            <translation>圆滑拐角</translation>
        </message>
        <message>
            <source>Pin this plan as B, and plan the fastest motion inside the tolerance</source>
            <translation>把此规划固定为 B，并规划公差内最快的运动</translation>
        </message>
        <message>
            <source>Your program…</source>
            <translation>您的程序…</translation>
        </message>
        <message>
            <source>Open a program of your own; it can be dropped here as well</source>
            <translation>打开您自己的程序；也可以拖放到这里</translation>
        </message>
        <message>
            <source>Close</source>
            <translation>关闭</translation>
        </message>
        <message>
            <source>Do not show this again</source>
            <translation>不再显示</translation>
        </message>
    </context>
    <context>
        <name>OptionNames</name>
        <message>
            <source>exact stop</source>
            <translation>准停</translation>
        </message>
        <message>
            <source>servo step (a·Ts)</source>
            <translation>伺服步进 (a·Ts)</translation>
        </message>
        <message>
            <source>junction deviation</source>
            <translation>拐角偏差</translation>
        </message>
        <message>
            <source>blend in tolerance</source>
            <translation>公差内过渡</translation>
        </message>
        <message>
            <source>smooth in tolerance</source>
            <translation>公差内光顺</translation>
        </message>
        <message>
            <source>end inside their block</source>
            <translation>在程序段内完成</translation>
        </message>
        <message>
            <source>run across blocks</source>
            <translation>跨程序段</translation>
        </message>
        <message>
            <source>velocity law</source>
            <translation>速度规律</translation>
        </message>
        <message>
            <source>corners</source>
            <translation>拐角</translation>
        </message>
        <message>
            <source>ramps</source>
            <translation>加减速段</translation>
        </message>
        <message>
            <source>acceleration</source>
            <translation>加速度</translation>
        </message>
        <message>
            <source>jerk</source>
            <translation>加加速度</translation>
        </message>
        <message>
            <source>times of ramps</source>
            <translation>加减速时间</translation>
        </message>
        <message>
            <source>tolerance</source>
            <translation>公差</translation>
        </message>
        <message>
            <source>look-ahead</source>
            <translation>前瞻</translation>
        </message>
        <message>
            <source>none</source>
            <translation>无</translation>
        </message>
    </context>
    <context>
        <name>SettingDifferences</name>
        <message>
            <source>Program</source>
            <translation>程序</translation>
        </message>
        <message>
            <source>Machine</source>
            <translation>机床</translation>
        </message>
        <message>
            <source>Law</source>
            <translation>规律</translation>
        </message>
        <message>
            <source>Look-ahead</source>
            <translation>前瞻</translation>
        </message>
        <message>
            <source>Ramps</source>
            <translation>加减速</translation>
        </message>
        <message>
            <source>Corners</source>
            <translation>拐角</translation>
        </message>
        <message>
            <source>Speed step at corners</source>
            <translation>拐角速度阶跃</translation>
        </message>
        <message>
            <source>Feed hold</source>
            <translation>进给保持</translation>
        </message>
        <message>
            <source>Shaper</source>
            <translation>整形器</translation>
        </message>
        <message>
            <source>Modes of %1</source>
            <translation>%1 轴的模态</translation>
        </message>
    </context>
    <context>
        <name>ParameterTips</name>
        <message>
            <source>How a ramp changes the speed: its duration T(Δv), and v = v₀ + Δv·f(t/T)</source>
            <translation>加减速如何改变速度：时长 T(Δv)，v = v₀ + Δv·f(t/T)</translation>
        </message>
        <message>
            <source>A ramp up lasts as long, whatever the change of speed: its peak acceleration is 2·Δv/Tacc</source>
            <translation>无论速度变化多少，加速都持续这么久：峰值加速度为 2·Δv/Tacc</translation>
        </message>
        <message>
            <source>A ramp down lasts as long, whatever the change of speed: its peak deceleration is 2·Δv/Tdec</source>
            <translation>无论速度变化多少，减速都持续这么久：峰值减速度为 2·Δv/Tdec</translation>
        </message>
        <message>
            <source>The path is never sped up harder: dv/dt ≤ Am</source>
            <translation>沿路径加速不会更猛：dv/dt ≤ Am</translation>
        </message>
        <message>
            <source>The path is never slowed down harder: −dv/dt ≤ Dm</source>
            <translation>沿路径减速不会更猛：−dv/dt ≤ Dm</translation>
        </message>
        <message>
            <source>The acceleration changes no faster while the path is sped up: |da/dt| ≤ Jm</source>
            <translation>加速时加速度变化不会更快：|da/dt| ≤ Jm</translation>
        </message>
        <message>
            <source>The acceleration changes no faster while the path is slowed down: |da/dt| ≤ Jd</source>
            <translation>减速时加速度变化不会更快：|da/dt| ≤ Jd</translation>
        </message>
        <message>
            <source>No block is run faster, whatever its feed: v ≤ Vmax</source>
            <translation>无论进给多大，任何程序段都不会更快：v ≤ Vmax</translation>
        </message>
        <message>
            <source>Time between two setpoints; on an arc of radius r the chord between them is (v·Ts)²/(8·r) off</source>
            <translation>两个设定点之间的时间；在半径 r 的圆弧上，其弦偏离 (v·Ts)²/(8·r)</translation>
        </message>
        <message>
            <source>So many blocks are known ahead: v ≤ reach(0, Σ L), from which the tool comes to rest at the end of the last one</source>
            <translation>预先知道这么多程序段：v ≤ reach(0, Σ L)，刀具能在最后一段末尾停住</translation>
        </message>
        <message>
            <source>Whether a ramp has to fit its block, (v₀ + v₁)/2·T(|v₁ − v₀|) ≤ L, or may go on in the next ones</source>
            <translation>加减速必须在本段内完成，(v₀ + v₁)/2·T(|v₁ − v₀|) ≤ L，还是可以延续到后面的段</translation>
        </message>
        <message>
            <source>How a corner of angle α is passed: at rest, v = 0; servo step, v·|Δu| ≤ a·Ts; junction deviation, v² ≤ a·δ·cos(α/2)/(1 − cos(α/2)); or rounded inside the tolerance</source>
            <translation>如何通过角度为 α 的拐角：停止，v = 0；伺服步进，v·|Δu| ≤ a·Ts；拐角偏差，v² ≤ a·δ·cos(α/2)/(1 − cos(α/2))；或在公差内倒圆</translation>
        </message>
        <message>
            <source>From this time on the path is slowed down to rest, and stays there: v → 0 under Dm and Jd</source>
            <translation>从此刻起沿路径减速至停止并保持：v → 0，受 Dm 与 Jd 限制</translation>
        </message>
        <message>
            <source>Rounded corners stay this close to the programmed path: distance ≤ tolerance; a G64 P of the program comes first</source>
            <translation>倒圆的拐角与编程路径的距离 ≤ 公差；程序中的 G64 P 优先</translation>
        </message>
        <message>
            <source>Passing a corner of angle α as if on a circle this far from it: v² ≤ a·δ·cos(α/2)/(1 − cos(α/2))</source>
            <translation>通过角度为 α 的拐角时，如同走在距拐角这么远的圆上：v² ≤ a·δ·cos(α/2)/(1 − cos(α/2))</translation>
        </message>
        <message>
            <source>Programmed feeds are multiplied by it: v ≤ F · override</source>
            <translation>编程进给乘以此值：v ≤ F · 倍率</translation>
        </message>
        <message>
            <source>Rapid traverse is multiplied by it: v ≤ rapid · override</source>
            <translation>快移速度乘以此值：v ≤ 快移 · 倍率</translation>
        </message>
    </context>
    <context>
        <name>toolpace::ui::SpectrumPage</name>
        <message>
            <source>along the path</source>
            <translation>沿路径</translation>
        </message>
        <message>
            <source>axis %1</source>
            <translation>%1 轴</translation>
        </message>
        <message>
            <source>amplitude</source>
            <translation>幅值</translation>
        </message>
        <message>
            <source>speed</source>
            <translation>速度</translation>
        </message>
        <message>
            <source>Nothing is planned</source>
            <translation>尚无规划</translation>
        </message>
        <message>
            <source>largest: %1 %2 at %3 Hz · running %4</source>
            <translation>最大：%3 Hz 处 %1 %2 · 运行 %4</translation>
        </message>
        <message>
            <source>Acceleration of</source>
            <translation>加速度</translation>
        </message>
        <message>
            <source>Whose commanded acceleration: a(t) = d²x/dt²</source>
            <translation>哪个轴的指令加速度：a(t) = d²x/dt²</translation>
        </message>
        <message>
            <source>Time</source>
            <translation>时间</translation>
        </message>
        <message>
            <source>The whole program, or what the plots show of it</source>
            <translation>整个程序，或图中可见的部分</translation>
        </message>
        <message>
            <source>whole program</source>
            <translation>整个程序</translation>
        </message>
        <message>
            <source>visible time</source>
            <translation>可见时间</translation>
        </message>
        <message>
            <source>Spectrum of the commanded acceleration</source>
            <translation>指令加速度的频谱</translation>
        </message>
        <message>
            <source>A sine of amplitude A at frequency f stands as A at f; dashed: modes of the axis</source>
            <translation>频率 f、幅值 A 的正弦在 f 处显示为 A；虚线：该轴的模态</translation>
        </message>
        <message>
            <source>Time at each speed</source>
            <translation>各速度的时间</translation>
        </message>
        <message>
            <source>How long the tool runs at a speed, by what allows no more</source>
            <translation>刀具在各速度下运行多久，以及受什么限制</translation>
        </message>
        <message>
            <source>What limits the speed</source>
            <translation>限制速度的因素</translation>
        </message>
        <message>
            <source>Colours of the limits, as in the preview and below the plots</source>
            <translation>各限制的颜色，与预览和图下方相同</translation>
        </message>
        <message>
            <source>frequency  Hz</source>
            <translation>频率  Hz</translation>
        </message>
        <message>
            <source>time  s</source>
            <translation>时间  s</translation>
        </message>
        <message>
            <source>The time is too short for a spectrum</source>
            <translation>时间太短，无法计算频谱</translation>
        </message>
    </context>
    <context>
        <name>toolpace::studio::ExportDialog</name>
        <message>
            <source>Save setpoints</source>
            <translation>保存设定点</translation>
        </message>
        <message>
            <source>Format</source>
            <translation>格式</translation>
        </message>
        <message>
            <source>How the setpoints are written</source>
            <translation>设定点的写法</translation>
        </message>
        <message>
            <source>with v, a, j of each axis</source>
            <translation>含各轴的 v、a、j</translation>
        </message>
        <message>
            <source>Differences of the positions, as a check of them would take</source>
            <translation>位置的差分，与检查所用的相同</translation>
        </message>
        <message>
            <source>decimal comma</source>
            <translation>小数逗号</translation>
        </message>
        <message>
            <source>For spreadsheets that expect 1,5 instead of 1.5</source>
            <translation>用于以 1,5 表示 1.5 的电子表格</translation>
        </message>
        <message>
            <source>Save as…</source>
            <translation>另存为…</translation>
        </message>
        <message>
            <source>Cancel</source>
            <translation>取消</translation>
        </message>
        <message>
            <source>%1 setpoints, one each %2 ms, over %3.</source>
            <translation>%1 个设定点，每 %2 ms 一个，共 %3。</translation>
        </message>
        <message>
            <source>The file takes about %1.</source>
            <translation>文件大约 %1。</translation>
        </message>
        <message>
            <source>How large the file gets is not known.</source>
            <translation>文件大小未知。</translation>
        </message>
    </context>
    <context>
        <name>ControllerNames</name>
        <message>
            <source>, %1 of it for blocks that have not come</source>
            <translation>，其中 %1 在等未到的程序段</translation>
        </message>
        <message>
            <source>step idle delay</source>
            <translation>步进空闲延时</translation>
        </message>
        <message>
            <source>junction deviation</source>
            <translation>拐角偏差</translation>
        </message>
        <message>
            <source>arc tolerance</source>
            <translation>圆弧容差</translation>
        </message>
        <message>
            <source>laser mode</source>
            <translation>激光模式</translation>
        </message>
        <message>
            <source>steps</source>
            <translation>脉冲当量</translation>
        </message>
        <message>
            <source>rate</source>
            <translation>最大速率</translation>
        </message>
        <message>
            <source>acceleration</source>
            <translation>加速度</translation>
        </message>
        <message>
            <source>planner buffer</source>
            <translation>规划缓冲</translation>
        </message>
        <message>
            <source>speed</source>
            <translation>速度</translation>
        </message>
        <message>
            <source>square corner velocity</source>
            <translation>直角拐角速度</translation>
        </message>
        <message>
            <source>minimum cruise ratio</source>
            <translation>最小匀速比例</translation>
        </message>
        <message>
            <source>arc resolution</source>
            <translation>圆弧分段长度</translation>
        </message>
        <message>
            <source>nozzle</source>
            <translation>喷嘴直径</translation>
        </message>
        <message>
            <source>filament</source>
            <translation>耗材直径</translation>
        </message>
        <message>
            <source>speed of the extruder alone</source>
            <translation>单独挤出的速度</translation>
        </message>
        <message>
            <source>acceleration of the extruder alone</source>
            <translation>单独挤出的加速度</translation>
        </message>
        <message>
            <source>extruder&apos;s step of speed at corners</source>
            <translation>挤出机拐角速度阶跃</translation>
        </message>
        <message>
            <source>feedrate</source>
            <translation>最大进给速度</translation>
        </message>
        <message>
            <source>printing acceleration</source>
            <translation>打印加速度</translation>
        </message>
        <message>
            <source>travel acceleration</source>
            <translation>空移加速度</translation>
        </message>
        <message>
            <source>minimum feedrate</source>
            <translation>最小进给速度</translation>
        </message>
        <message>
            <source>minimum travel feedrate</source>
            <translation>最小空移速度</translation>
        </message>
        <message>
            <source>path velocity</source>
            <translation>路径速度</translation>
        </message>
        <message>
            <source>look-ahead</source>
            <translation>前瞻</translation>
        </message>
        <message>
            <source>arc blends</source>
            <translation>圆弧过渡</translation>
        </message>
        <message>
            <source>kink that passes as tangent</source>
            <translation>视为相切的折角</translation>
        </message>
        <message>
            <source>most feed override</source>
            <translation>最大进给倍率</translation>
        </message>
        <message>
            <source>least length of a blend</source>
            <translation>过渡最短长度</translation>
        </message>
        <message>
            <source>ramp frequency</source>
            <translation>斜坡频率</translation>
        </message>
        <message>
            <source>cycle of the interpreter</source>
            <translation>解释器周期</translation>
        </message>
        <message>
            <source>servo period</source>
            <translation>伺服周期</translation>
        </message>
        <message>
            <source>blend tolerance</source>
            <translation>过渡公差</translation>
        </message>
        <message>
            <source>velocity</source>
            <translation>速度</translation>
        </message>
        <message>
            <source>programmed feed</source>
            <translation>编程进给</translation>
        </message>
        <message>
            <source>rapid</source>
            <translation>快移</translation>
        </message>
        <message>
            <source>speed of the axes</source>
            <translation>轴速度</translation>
        </message>
        <message>
            <source>corners</source>
            <translation>拐角</translation>
        </message>
        <message>
            <source>link</source>
            <translation>通信</translation>
        </message>
        <message>
            <source>stops</source>
            <translation>停顿</translation>
        </message>
        <message>
            <source>dwell</source>
            <translation>暂停</translation>
        </message>
        <message>
            <source>blocks</source>
            <translation>段</translation>
        </message>
        <message>
            <source>cycles</source>
            <translation>周期</translation>
        </message>
        <message>
            <source>On %1 %2</source>
            <translation>在 %1 上 %2</translation>
        </message>
        <message>
            <source>; as setpoints %1</source>
            <translation>；作为设定点 %1</translation>
        </message>
    </context>
    <context>
        <name>toolpace::studio::ControllerFile</name>
        <message>
            <source>Choose a controller</source>
            <translation>选择控制器</translation>
        </message>
        <message>
            <source>Run on Toolpace&apos;s plan</source>
            <translation>按 Toolpace 的规划运行</translation>
        </message>
        <message>
            <source>Save settings</source>
            <translation>保存设置</translation>
        </message>
        <message>
            <source>Settings file changed</source>
            <translation>设置文件已更改</translation>
        </message>
    </context>
    <context>
        <name>toolpace::ui::ControllerPanel</name>
        <message>
            <source>It reads programs from its own disk</source>
            <translation>它从自己的磁盘读取程序</translation>
        </message>
        <message>
            <source>trying… %1 %</source>
            <translation>正在尝试… %1 %</translation>
        </message>
        <message>
            <source>predicting…</source>
            <translation>正在预测…</translation>
        </message>
        <message>
            <source>Choose a controller: Runs on</source>
            <translation>请选择控制器：运行于</translation>
        </message>
        <message>
            <source>(stale)</source>
            <translation>（过时）</translation>
        </message>
        <message>
            <source>Double click: take this value</source>
            <translation>双击：采用该值</translation>
        </message>
        <message>
            <source>Cancel</source>
            <translation>取消</translation>
        </message>
        <message>
            <source>Try the settings</source>
            <translation>尝试各项设置</translation>
        </message>
        <message>
            <source>Predict with each setting 10 % up and down and at its next round value</source>
            <translation>每项设置增减 10 % 以及取下一个整值时重新预测</translation>
        </message>
        <message>
            <source>trying…</source>
            <translation>正在尝试…</translation>
        </message>
        <message>
            <source>What each setting would save</source>
            <translation>各项设置能节省多少</translation>
        </message>
        <message>
            <source>Held down by</source>
            <translation>限制因素</translation>
        </message>
        <message>
            <source>Time</source>
            <translation>时间</translation>
        </message>
        <message>
            <source>Setting</source>
            <translation>设置</translation>
        </message>
        <message>
            <source>Value</source>
            <translation>值</translation>
        </message>
        <message>
            <source>Saves</source>
            <translation>节省</translation>
        </message>
        <message>
            <source>Where the time goes on the controller</source>
            <translation>控制器上时间的去向</translation>
        </message>
    </context>
    <context>
        <name>toolpace::ui::ControllerSection</name>
        <message>
            <source>Not in the file: what the controller takes without it</source>
            <translation>文件中没有：控制器的默认值</translation>
        </message>
        <message>
            <source>Setting %1</source>
            <translation>设置 %1</translation>
        </message>
        <message>
            <source>Save</source>
            <translation>保存</translation>
        </message>
        <message>
            <source>Save the settings</source>
            <translation>保存设置</translation>
        </message>
        <message>
            <source>Write what was changed into the controller&apos;s settings file</source>
            <translation>把更改写入控制器的设置文件</translation>
        </message>
    </context>
    <context>
        <name>toolpace::studio::RewriteDialog</name>
        <message>
            <source>Program for this controller</source>
            <translation>适合此控制器的程序</translation>
        </message>
        <message>
            <source>Save as…</source>
            <translation>另存为…</translation>
        </message>
        <message>
            <source>Close</source>
            <translation>关闭</translation>
        </message>
        <message>
            <source>Progress</source>
            <translation>进度</translation>
        </message>
        <message>
            <source>stopped</source>
            <translation>已停止</translation>
        </message>
        <message>
            <source>arcs and helices</source>
            <translation>圆弧和螺旋线</translation>
        </message>
        <message>
            <source>Else lines alone</source>
            <translation>否则只用直线</translation>
        </message>
        <message>
            <source>lower feeds that cannot be held</source>
            <translation>降低无法保持的进给</translation>
        </message>
        <message>
            <source>Where axes could not follow, or blocks would come too late; never above the program&apos;s</source>
            <translation>在轴跟不上或程序段来得太迟之处；绝不高于程序的进给</translation>
        </message>
        <message>
            <source>Result</source>
            <translation>结果</translation>
        </message>
        <message>
            <source>Before</source>
            <translation>之前</translation>
        </message>
        <message>
            <source>After</source>
            <translation>之后</translation>
        </message>
        <message>
            <source>Change</source>
            <translation>变化</translation>
        </message>
        <message>
            <source>What comes of it</source>
            <translation>所得结果</translation>
        </message>
        <message>
            <source>as the controller reads it</source>
            <translation>按控制器的读法</translation>
        </message>
        <message>
            <source>Runs on</source>
            <translation>运行于</translation>
        </message>
        <message>
            <source>Read as</source>
            <translation>读作</translation>
        </message>
        <message>
            <source>Tolerance</source>
            <translation>公差</translation>
        </message>
        <message>
            <source>Whose times count; parts that would take it longer stay as they are</source>
            <translation>以谁的时间为准；会用时更长的部分保持原样</translation>
        </message>
        <message>
            <source>The dialect that the program is read in</source>
            <translation>读取程序所用的方言</translation>
        </message>
        <message>
            <source>How far the new path may be from the old one</source>
            <translation>新路径与旧路径的最大距离</translation>
        </message>
        <message>
            <source>Blue: the program. Red: what is written instead, its deviation enlarged</source>
            <translation>蓝色：原程序。红色：改写后的程序，偏差已放大</translation>
        </message>
        <message>
            <source>Enlargement of the deviation</source>
            <translation>偏差放大倍数</translation>
        </message>
        <message>
            <source>The program and what is written instead</source>
            <translation>原程序与改写后的程序</translation>
        </message>
        <message>
            <source>Lines</source>
            <translation>行</translation>
        </message>
        <message>
            <source>Blocks</source>
            <translation>程序段</translation>
        </message>
        <message>
            <source>Time</source>
            <translation>时间</translation>
        </message>
        <message>
            <source>Saves</source>
            <translation>节省</translation>
        </message>
        <message>
            <source>Where the gain is</source>
            <translation>收益所在</translation>
        </message>
        <message>
            <source>Toolpace&apos;s plan</source>
            <translation>Toolpace 的规划</translation>
        </message>
        <message>
            <source>Other settings…</source>
            <translation>其他设置…</translation>
        </message>
        <message>
            <source>Settings of the controller</source>
            <translation>控制器的设置</translation>
        </message>
        <message>
            <source>Settings (*.ini *.txt *.cfg *.nc *.gcode *.log);;All files (*)</source>
            <translation>设置 (*.ini *.txt *.cfg *.nc *.gcode *.log);;所有文件 (*)</translation>
        </message>
        <message>
            <source>Size</source>
            <translation>大小</translation>
        </message>
        <message>
            <source>Deviation</source>
            <translation>偏差</translation>
        </message>
        <message>
            <source>of %1</source>
            <translation>允许 %1</translation>
        </message>
        <message>
            <source>Nothing gains by being written otherwise: the file would be the program as it is.</source>
            <translation>改写没有任何收益：文件将与程序原样相同。</translation>
        </message>
        <message>
            <source>%1 blocks stay as they are: otherwise they would take longer.</source>
            <translation>%1 个程序段保持原样：否则用时更长。</translation>
        </message>
        <message>
            <source>%1 stretches stay as they are: their proof did not hold.</source>
            <translation>%1 段保持原样：其证明不成立。</translation>
        </message>
        <message>
            <source>The deviation is not drawn.</source>
            <translation>未绘制偏差。</translation>
        </message>
        <message>
            <source>Stop</source>
            <translation>停止</translation>
        </message>
        <message>
            <source>Try again</source>
            <translation>重试</translation>
        </message>
        <message>
            <source>writing the program anew…</source>
            <translation>正在改写程序…</translation>
        </message>
        <message>
            <source>Everything but runs of plain G1, G2 and G3 lines stays byte for byte.</source>
            <translation>除连续的普通 G1、G2、G3 行外，其余逐字节保持不变。</translation>
        </message>
    </context>
    <context>
        <name>toolpace::studio::TraceDialog</name>
        <message>
            <source>Columns of the trace</source>
            <translation>测量记录的列</translation>
        </message>
        <message>
            <source>What the columns of %1 mean:</source>
            <translation>%1 各列的含义：</translation>
        </message>
        <message>
            <source>Without a column for the time, from row to row</source>
            <translation>没有时间列时，行间隔</translation>
        </message>
        <message>
            <source>Time from row to row</source>
            <translation>行间隔时间</translation>
        </message>
        <message>
            <source>Of a trace without times</source>
            <translation>用于没有时间的记录</translation>
        </message>
        <message>
            <source>Compare</source>
            <translation>比较</translation>
        </message>
        <message>
            <source>Cancel</source>
            <translation>取消</translation>
        </message>
        <message>
            <source>Column</source>
            <translation>列</translation>
        </message>
        <message>
            <source>Means</source>
            <translation>含义</translation>
        </message>
        <message>
            <source>Unit</source>
            <translation>单位</translation>
        </message>
        <message>
            <source>First values</source>
            <translation>前几个值</translation>
        </message>
        <message>
            <source>nothing</source>
            <translation>不使用</translation>
        </message>
        <message>
            <source>time</source>
            <translation>时间</translation>
        </message>
        <message>
            <source>%1, actual</source>
            <translation>%1，实际</translation>
        </message>
        <message>
            <source>%1, commanded</source>
            <translation>%1，指令</translation>
        </message>
        <message>
            <source>Meaning of %1</source>
            <translation>%1 的含义</translation>
        </message>
        <message>
            <source>Unit of %1</source>
            <translation>%1 的单位</translation>
        </message>
        <message>
            <source>Two columns mean the same.</source>
            <translation>有两列含义相同。</translation>
        </message>
        <message>
            <source>No column tells where an axis was.</source>
            <translation>没有一列给出轴的实际位置。</translation>
        </message>
        <message>
            <source>No column is the time.</source>
            <translation>没有时间列。</translation>
        </message>
        <message>
            <source>Where an axis was commanded helps to find its lag, but is not needed.</source>
            <translation>轴的指令位置有助于求出其滞后，但并非必需。</translation>
        </message>
    </context>
    <context>
        <name>toolpace::ui::CausesPanel</name>
        <message>
            <source>Held down by</source>
            <translation>受限于</translation>
        </message>
        <message>
            <source>Time</source>
            <translation>时间</translation>
        </message>
        <message>
            <source>Where the time goes</source>
            <translation>时间去向</translation>
        </message>
    </context>
    <context>
        <name>toolpace::ui::FrontDial</name>
        <message>
            <source>vibration %1</source>
            <translation>振动 %1</translation>
        </message>
        <message>
            <source>rough</source>
            <translation>粗加工</translation>
        </message>
        <message>
            <source>finish</source>
            <translation>半精</translation>
        </message>
        <message>
            <source>fine</source>
            <translation>精加工</translation>
        </message>
        <message>
            <source>From rough to fine</source>
            <translation>从粗到精</translation>
        </message>
        <message>
            <source>The best settings from the fastest to the most accurate</source>
            <translation>从最快到最精确的最佳设置</translation>
        </message>
        <message>
            <source>Cycle time and contour error of the settings in use</source>
            <translation>当前设置的循环时间和轮廓误差</translation>
        </message>
        <message>
            <source>Balanced</source>
            <translation>均衡</translation>
        </message>
        <message>
            <source>Where a little more accuracy begins to cost much time</source>
            <translation>再提高一点精度就要多花许多时间之处</translation>
        </message>
        <message>
            <source>Fastest within the limit</source>
            <translation>限值内最快</translation>
        </message>
        <message>
            <source>The fastest settings whose contour error is within the limit</source>
            <translation>轮廓误差在限值内的最快设置</translation>
        </message>
    </context>
    <context>
        <name>toolpace::ui::FrontPlot</name>
        <message>
            <source>vibration left by stops</source>
            <translation>停止后的残余振动</translation>
        </message>
        <message>
            <source>Cycle time against contour error of the best settings</source>
            <translation>最佳设置的循环时间与轮廓误差</translation>
        </message>
        <message>
            <source>Click on a point to take its settings</source>
            <translation>点击一点即采用其设置</translation>
        </message>
        <message>
            <source>cycle time</source>
            <translation>循环时间</translation>
        </message>
        <message>
            <source>contour error</source>
            <translation>轮廓误差</translation>
        </message>
        <message>
            <source>limit</source>
            <translation>限值</translation>
        </message>
        <message>
            <source>in use</source>
            <translation>当前</translation>
        </message>
    </context>
    <context>
        <name>toolpace::ui::SingleChangesPanel</name>
        <message>
            <source>planning… %1 %</source>
            <translation>规划中… %1 %</translation>
        </message>
        <message>
            <source>Cancel</source>
            <translation>取消</translation>
        </message>
        <message>
            <source>Try each</source>
            <translation>逐项尝试</translation>
        </message>
        <message>
            <source>Plan again with each limit 10 % up and down and with every other choice, each alone</source>
            <translation>每次只改一项重新规划：各限值上下 10 %，以及每个其他选项</translation>
        </message>
        <message>
            <source>Each setting alone: what it saves, what error it adds</source>
            <translation>每项设置单独改变：节省多少，增加多少误差</translation>
        </message>
        <message>
            <source>Of other settings: try again</source>
            <translation>属于其他设置：请重新尝试</translation>
        </message>
        <message>
            <source>What helps most</source>
            <translation>什么最有用</translation>
        </message>
        <message>
            <source>One change</source>
            <translation>单项更改</translation>
        </message>
        <message>
            <source>Saves</source>
            <translation>节省</translation>
        </message>
        <message>
            <source>Error</source>
            <translation>误差</translation>
        </message>
        <message>
            <source>What each change alone saves, and the contour error that it adds</source>
            <translation>每项更改单独节省的时间和增加的轮廓误差</translation>
        </message>
        <message>
            <source>Double click or Enter takes a change</source>
            <translation>双击或按回车采用一项更改</translation>
        </message>
        <message>
            <source>%1 others make no difference.</source>
            <translation>另有 %1 项没有影响。</translation>
        </message>
        <message>
            <source>Double click or Enter takes a change.</source>
            <translation>双击或按回车采用一项更改。</translation>
        </message>
    </context>
    <context>
        <name>toolpace::ui::TracePage</name>
        <message>
            <source>comparing…</source>
            <translation>比较中…</translation>
        </message>
        <message>
            <source>Open what a scope recorded while the program ran</source>
            <translation>打开程序运行时示波器的记录</translation>
        </message>
        <message>
            <source>%1: %2 rows, the program starts at %3 s of the trace, correlation %4</source>
            <translation>%1：%2 行，程序始于记录的 %3 s，相关系数 %4</translation>
        </message>
        <message>
            <source>clocks drift by %1 ppm</source>
            <translation>时钟漂移 %1 ppm</translation>
        </message>
        <message>
            <source>Contour error %1 %3 at most, %2 %3 RMS</source>
            <translation>轮廓误差最大 %1 %3，均方根 %2 %3</translation>
        </message>
        <message>
            <source>a lag that all axes share does not show</source>
            <translation>各轴共有的滞后无法看出</translation>
        </message>
        <message>
            <source>It fits at another place of the program nearly as well</source>
            <translation>它在程序的另一处也几乎同样吻合</translation>
        </message>
        <message>
            <source>Axis %1 moves, and is not in the trace</source>
            <translation>轴 %1 在运动，但记录中没有它</translation>
        </message>
        <message>
            <source>Axis</source>
            <translation>轴</translation>
        </message>
        <message>
            <source>Lag</source>
            <translation>滞后</translation>
        </message>
        <message>
            <source>Following</source>
            <translation>跟随</translation>
        </message>
        <message>
            <source>RMS</source>
            <translation>均方根</translation>
        </message>
        <message>
            <source>Worst line</source>
            <translation>最差行</translation>
        </message>
        <message>
            <source>Line</source>
            <translation>行</translation>
        </message>
        <message>
            <source>Contour</source>
            <translation>轮廓</translation>
        </message>
        <message>
            <source>Lag and following error of each axis</source>
            <translation>各轴的滞后和跟随误差</translation>
        </message>
        <message>
            <source>Click on a row to go to its worst line</source>
            <translation>点击一行转到其最差的程序行</translation>
        </message>
        <message>
            <source>Contour and following error of each NC line</source>
            <translation>各 NC 行的轮廓误差和跟随误差</translation>
        </message>
        <message>
            <source>Click on a row to go there</source>
            <translation>点击一行转到该处</translation>
        </message>
        <message>
            <source>Open trace…</source>
            <translation>打开记录…</translation>
        </message>
        <message>
            <source>Open a trace</source>
            <translation>打开测量记录</translation>
        </message>
        <message>
            <source>Columns…</source>
            <translation>列…</translation>
        </message>
        <message>
            <source>Columns of the trace</source>
            <translation>测量记录的列</translation>
        </message>
        <message>
            <source>Say anew what the columns mean</source>
            <translation>重新指定各列的含义</translation>
        </message>
        <message>
            <source>Close</source>
            <translation>关闭</translation>
        </message>
        <message>
            <source>Close the trace</source>
            <translation>关闭测量记录</translation>
        </message>
    </context>
    <context>
        <name>toolpace::ui::TuneSettingsPanel</name>
        <message>
            <source>Best settings</source>
            <translation>最佳设置</translation>
        </message>
        <message>
            <source>searching… %1 %</source>
            <translation>搜索中… %1 %</translation>
        </message>
        <message>
            <source>Setting</source>
            <translation>设置</translation>
        </message>
        <message>
            <source>Now</source>
            <translation>现在</translation>
        </message>
        <message>
            <source>Best</source>
            <translation>最佳</translation>
        </message>
        <message>
            <source>The settings by which this program is fastest on its controller, by that one's own model</source>
            <translation>按控制器自身的模型，使该程序在其上最快的设置</translation>
        </message>
        <message>
            <source>Of another program or other settings: search again</source>
            <translation>属于其他程序或其他设置：请重新搜索</translation>
        </message>
        <message>
            <source>%1 now, %2 at best</source>
            <translation>现在 %1，最佳 %2</translation>
        </message>
        <message>
            <source>nothing that may change helps</source>
            <translation>可更改的设置都无帮助</translation>
        </message>
        <message>
            <source>Cancel</source>
            <translation>取消</translation>
        </message>
        <message>
            <source>Search</source>
            <translation>搜索</translation>
        </message>
        <message>
            <source>Leave it</source>
            <translation>放弃</translation>
        </message>
        <message>
            <source>Try other values of the settings that are ticked</source>
            <translation>试用已勾选设置的其他取值</translation>
        </message>
        <message>
            <source>Up to the machine's limits</source>
            <translation>直至机床极限</translation>
        </message>
        <message>
            <source>No setting goes beyond what the machine of the page Limits can do; else beyond what it has now</source>
            <translation>任何设置都不超过“极限”页中机床的能力；否则不超过现值</translation>
        </message>
        <message>
            <source>Take</source>
            <translation>采用</translation>
        </message>
        <message>
            <source>Take the best settings</source>
            <translation>采用最佳设置</translation>
        </message>
        <message>
            <source>All changes at once; undo gives the settings back</source>
            <translation>一次完成全部更改；撤销即可恢复设置</translation>
        </message>
        <message>
            <source>Settings of the controller</source>
            <translation>控制器的设置</translation>
        </message>
        <message>
            <source>Those that are ticked may change</source>
            <translation>已勾选者可以更改</translation>
        </message>
    </context>
    <context>
        <name>toolpace::ui::TunePage</name>
        <message>
            <source>searching… %1 %</source>
            <translation>搜索中… %1 %</translation>
        </message>
        <message>
            <source>Best settings</source>
            <translation>最佳设置</translation>
        </message>
        <message>
            <source>What changes</source>
            <translation>更改内容</translation>
        </message>
        <message>
            <source>There: %1</source>
            <translation>该处：%1</translation>
        </message>
        <message>
            <source>What was changed</source>
            <translation>已更改的内容</translation>
        </message>
        <message>
            <source>Setting</source>
            <translation>设置</translation>
        </message>
        <message>
            <source>Now</source>
            <translation>现在</translation>
        </message>
        <message>
            <source>Before</source>
            <translation>之前</translation>
        </message>
        <message>
            <source>There</source>
            <translation>该处</translation>
        </message>
        <message>
            <source>Search</source>
            <translation>搜索</translation>
        </message>
        <message>
            <source>Cancel</source>
            <translation>取消</translation>
        </message>
        <message>
            <source>Stop</source>
            <translation>停止</translation>
        </message>
        <message>
            <source>Plan with many settings and keep those that nothing beats</source>
            <translation>用许多设置规划，保留无可超越者</translation>
        </message>
        <message>
            <source>Leave what was found</source>
            <translation>放弃已找到的结果</translation>
        </message>
        <message>
            <source>End the search with what was found so far</source>
            <translation>以目前找到的结果结束搜索</translation>
        </message>
        <message>
            <source>Cycle time against contour error: which settings nothing beats</source>
            <translation>循环时间对轮廓误差：哪些设置无可超越</translation>
        </message>
        <message>
            <source>Of another program or other settings: search again</source>
            <translation>属于其他程序或其他设置：请重新搜索</translation>
        </message>
        <message>
            <source>%1 plans, %2 that nothing beats</source>
            <translation>%1 次规划，%2 个无可超越</translation>
        </message>
        <message>
            <source>best %1</source>
            <translation>最佳 %1</translation>
        </message>
        <message>
            <source>none keeps the limit</source>
            <translation>没有一个满足限值</translation>
        </message>
        <message>
            <source>Contour error ≤</source>
            <translation>轮廓误差 ≤</translation>
        </message>
        <message>
            <source>as now</source>
            <translation>同现在</translation>
        </message>
        <message>
            <source>Largest contour error</source>
            <translation>最大轮廓误差</translation>
        </message>
        <message>
            <source>Largest contour error through the drives that the best may have; empty: that of the settings as they are</source>
            <translation>最佳设置经驱动后允许的最大轮廓误差；留空：与当前设置相同</translation>
        </message>
        <message>
            <source>Plans</source>
            <translation>规划次数</translation>
        </message>
        <message>
            <source>Number of plans</source>
            <translation>规划次数</translation>
        </message>
        <message>
            <source>How many plans the search may make</source>
            <translation>搜索最多可做多少次规划</translation>
        </message>
        <message>
            <source>Settings that change</source>
            <translation>更改的设置</translation>
        </message>
        <message>
            <source>Vibration ≤</source>
            <translation>振动 ≤</translation>
        </message>
        <message>
            <source>Largest vibration</source>
            <translation>最大振动</translation>
        </message>
        <message>
            <source>Largest residual of an axis after a stop that the best may have; empty: that of the settings as they are</source>
            <translation>最佳设置在停止后允许的最大轴残余振动；空：沿用现有设置的值</translation>
        </message>
    </context>
    <context>
        <name>toolpace::ui::VaryButton</name>
        <message>
            <source>Vary: all</source>
            <translation>可变：全部</translation>
        </message>
        <message>
            <source>Vary: %1 of %2</source>
            <translation>可变：%1/%2</translation>
        </message>
        <message>
            <source>Which settings the search may change</source>
            <translation>搜索可以更改哪些设置</translation>
        </message>
    </context>
</TS>
