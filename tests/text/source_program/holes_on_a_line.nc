O9200 (section 12.2 corrected: five holes at 30 degrees)
G90 G54 G00 X0 Y0 Z10.
G99 G81 X0. Y0. Z-200. R-150. F1000 K0
G65 P9401 X40. Y-200. A30. U10. H5
#500=#4003 (expect #500=90)
G80
M02
O9401
#3=#4003
#12=3000
#13=03
S#12 M#13
G90 X#24 Y#25
WHILE[#11GT1]DO1
G91 X[#21*COS[#1]] Y[#21*SIN[#1]]
#11=#11-1
END1
G#3
M99
(finally records: spindle cw 3000)
(finally work X74.64 Y-180 Z-150)
(finally moves: rapid Z10; rapid X40 Y-200 Z10; rapid Z-150; line X40 Y-200 Z-200 F1000; rapid Z-150; rapid X48.66 Y-195; line Z-200; rapid Z-150; rapid X57.32 Y-190; line Z-200; rapid Z-150; rapid X65.98 Y-185; line Z-200; rapid Z-150; rapid X74.64 Y-180; line Z-200; rapid Z-150)
