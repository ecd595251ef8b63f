(run with: --param PRT=0)
O1 (OUT-4, section 7.1: PRT 0, sign and width are kept)
#2=128.47398
#5=-91.2
#30=123.456
DPRNT[X#2[53]Y#5[53]T#30[20]]
M30
(finally prints X   128.474Y-   91.200T 23)
