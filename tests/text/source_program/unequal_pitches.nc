O1 (section 12.3 corrected: X 10 20 30 50 70)
G90
#100=0
#101=0
#102=0
G65 P9203 A0. I10. K3. I20. K2.
M30
O9203
#5=4
WHILE[#5LE31]DO1
IF[#[#5]EQ#0]GOTO 9001
#8=0
DO2
#101=#101+#[#5]*COS[#1]
#102=#102+#[#5]*SIN[#1]
X#101 Y#102
#100=#100+1
#8=#8+1
IF[#8GE#[#5+2]]GOTO 9002
END2
N9002
N9001 #5=#5+3
END1
#101=0
#102=0
M99
(finally #100=5, #101=0, #102=0)
(finally moves: rapid X10 Y0; rapid X20 Y0; rapid X30 Y0; rapid X50 Y0; rapid X70 Y0)
