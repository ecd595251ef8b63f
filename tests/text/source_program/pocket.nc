(run with: --param offset_memory=A --set #2001=10)
O1 (section 12.5 corrected: three depths, three rows)
G90 G00 Z50.
G65 P9802 X0. Y0. Z-10. R2. Q4. I100. J60. K0.5 T80 D1 F200. E100.
M30
O9802
#27=#[2000+#7]
#28=#6+#27
#29=#5-2*#28
#30=2*#27*#20/100
#31=FUP[#29/#30]
#32=#29/#31
#10=#24+#28
#11=#25+#28
#12=#24+#4-#28
#13=#26+#6
#500=#28
#501=#29
#502=#30
#503=#31
#504=#32
G00 X#10 Y#11
Z#18
#33=#18
WHILE[#33GT#13]DO1
IF[#33EQ#18]GOTO 1
G01 Z[#33+1] F[8*#8]
N1 #33=#33-#17
IF[#33GE#13]GOTO 2
#33=#13
N2 G01 Z#33 F#8
#15=1
WHILE[#15LE#31]DO2
IF[[#15AND1]EQ0]GOTO 3
X#12 F#9
GOTO 4
N3 X#10 F#9
N4 Y[#11+#15*#32]
#15=#15+1
END2
IF[[#31AND1]EQ0]GOTO 5
X#10
GOTO 6
N5 X#12
N6 G00 Z#18
X#10 Y#11
END1
M99
(finally #500=10.5, #501=39, #502=16, #503=3, #504=13)
(finally work X10.5 Y10.5 Z2)
(finally moves: rapid Z50; rapid X10.5 Y10.5; rapid Z2; line Z-2 F100; line X89.5 F200; line Y23.5; line X10.5; line Y36.5; line X89.5; line Y49.5; line X10.5; rapid Z2; rapid X10.5 Y10.5; line Z-1 F800; line Z-6 F100; line X89.5 F200; line Y23.5; line X10.5; line Y36.5; line X89.5; line Y49.5; line X10.5; rapid Z2; rapid X10.5 Y10.5; line Z-5 F800; line Z-9.5 F100; line X89.5 F200; line Y23.5; line X10.5; line Y36.5; line X89.5; line Y49.5; line X10.5; rapid Z2; rapid X10.5 Y10.5)
