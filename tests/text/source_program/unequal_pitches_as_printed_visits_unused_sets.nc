O1 (section 12.3 as printed: a vacant pitch EQ 0 is false, 13 positions)
G90
G65 P9203 A0. I10. K3. I20. K2.
M30
O9203
#5=4
WHILE[#5LE31]DO1
IF[#[#5]EQ0]GOTO 9001
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
M99
(finally #100=13, #101=70)
