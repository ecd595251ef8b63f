(run with: --param offset_memory=A --set #2001=10)
O1 (section 12.5: J is twice k + r, no rows, 0 by 0)
G65 P9802 J21. K0.5 T80 D1
M30
O9802
#27=#[2000+#7]
#28=#6+#27
#29=#5-2*#28
#101=#29
#30=2*#27*#20/100
#31=FUP[#29/#30]
#32=#29/#31 (expect alarm PS0112)
M99
(finally #101=0)
