O1 (OUT-4, section 7.1: PRT 1, no blanks, minus only)
#2=128.47398
#5=-91.2
#30=123.456
DPRNT[X#2[53]Y#5[53]T#30[20]]
M30
(finally prints X128.474Y-91.200T23)
