O1 (OUT-8: 1094861.636 in format 3 is hexadecimal 41424344)
#100=1094861.636
BPRNT[C**X#100[3]]
M30
(finally prints C  XABCD)
