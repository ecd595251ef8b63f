(run with: --param offset_memory=A --set #2001=10)
O1 (section 12.5 as printed: the width is in #20, not in #23)
G65 P9802 J60. K0.5 T80 D1
M30
O9802
#27=#[2000+#7]
#28=#6+#27
#29=#5-2*#28
#30=2*#27*#23/100
#31=FUP[#29/#30] (expect alarm PS0112)
M99
