<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="zh_CN" sourcelanguage="en">
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
            <source>Acceleration time, shorter</source>
            <translation>加速时间（缩短）</translation>
        </message>
        <message>
            <source>Deceleration time, shorter</source>
            <translation>减速时间（缩短）</translation>
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
    </context>
    <context>
        <name>QObject</name>
        <message>
            <source>is a folder</source>
            <translation>是文件夹</translation>
        </message>
    </context>
    <context>
        <name>codes</name>
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
            <source>What would more &amp;limits save?</source>
            <translation>放宽限值能省多少？(&amp;L)</translation>
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
    </context>
    <context>
        <name>toolpace::studio::MainWindow</name>
        <message>
            <source>Look-ahead</source>
            <translation>前瞻</translation>
        </message>
        <message>
            <source>Default limits</source>
            <translation>默认限值</translation>
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
            <source>Machine files (*.toml);;LinuxCNC configuration (*.ini);;grbl settings, as $$ lists them (*.txt)</source>
            <translation>机床文件 (*.toml);;LinuxCNC 配置 (*.ini);;grbl 设置（$$ 的输出） (*.txt)</translation>
        </message>
        <message>
            <source>Open machine</source>
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
            <source>Comma-separated (*.csv)</source>
            <translation>逗号分隔 (*.csv)</translation>
        </message>
        <message>
            <source>NumPy array (*.npy)</source>
            <translation>NumPy 数组 (*.npy)</translation>
        </message>
        <message>
            <source>NumPy archive (*.npz)</source>
            <translation>NumPy 归档 (*.npz)</translation>
        </message>
        <message>
            <source>LinuxCNC halstreamer (*.halstream)</source>
            <translation>LinuxCNC halstreamer (*.halstream)</translation>
        </message>
        <message>
            <source>Semicolons (*.semicolon.csv)</source>
            <translation>分号分隔 (*.semicolon.csv)</translation>
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
            <source>How much the contour error is enlarged</source>
            <translation>轮廓误差的放大倍数</translation>
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
    </context>
    <context>
        <name>toolpace::ui::DockTitle</name>
        <message>
            <source>stale</source>
            <translation>未更新</translation>
        </message>
        <message>
            <source>The plan shown is not yet the one of these parameters</source>
            <translation>所示规划尚未反映当前参数</translation>
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
        <message>
            <source>What holds the speed down</source>
            <translation>速度受限原因</translation>
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
        <message numerus="yes">
            <source>%1 s (%2 %) more than at the programmed feed all along, on %n line(s)</source>
            <translation>
                <numerusform>比全程按编程进给多 %1 s（%2 %），涉及 %n 行</numerusform>
            </translation>
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
            <source>planning</source>
            <translation>规划中</translation>
        </message>
        <message>
            <source>Progress</source>
            <translation>进度</translation>
        </message>
    </context>
    <context>
        <name>toolpace::ui::TuningPanel</name>
        <message>
            <source>Trapezoid</source>
            <translation>梯形</translation>
        </message>
        <message>
            <source>Five-phase, by time</source>
            <translation>五段（按时间）</translation>
        </message>
        <message>
            <source>Five-phase, by jerk</source>
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
            <source>Rapid override</source>
            <translation>快移倍率</translation>
        </message>
        <message>
            <source>Velocity law</source>
            <translation>速度规律</translation>
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
            <source>Corners</source>
            <translation>拐角</translation>
        </message>
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
            <source>Axis limits</source>
            <translation>轴限值</translation>
        </message>
        <message>
            <source>Feed</source>
            <translation>进给</translation>
        </message>
        <message>
            <source>Rapid</source>
            <translation>快移</translation>
        </message>
    </context>
    <context>
        <name>toolpace::ui::WhatIfPanel</name>
        <message>
            <source>planning… %1 %</source>
            <translation>规划中… %1 %</translation>
        </message>
        <message>
            <source>10 % more of each limit</source>
            <translation>各限值提高 10 %</translation>
        </message>
        <message>
            <source>Held down by</source>
            <translation>受限于</translation>
        </message>
        <message>
            <source>Time</source>
            <translation>时间</translation>
        </message>
        <message>
            <source>If raised</source>
            <translation>若提高</translation>
        </message>
        <message>
            <source>Saves</source>
            <translation>节省</translation>
        </message>
        <message>
            <source>Where the time goes</source>
            <translation>时间花在哪里</translation>
        </message>
        <message>
            <source>What raising a limit saves</source>
            <translation>提高限值能省的时间</translation>
        </message>
        <message>
            <source>Plan it</source>
            <translation>开始规划</translation>
        </message>
        <message>
            <source>Plan again with each limit 10 % higher and list what it saves</source>
            <translation>将各限值分别提高 10 % 重新规划，并列出节省的时间</translation>
        </message>
    </context>
    <context>
        <name>toolpace::ui::Workspace</name>
        <message>
            <source>Swap A and B</source>
            <translation>交换 A 与 B</translation>
        </message>
    </context>
</TS>
