O1 (M99-2: the first of three passes leaves for good)
M98 P2 L3
#101=1
N50 M30
O2
#100=#100+1
M99 P50
(finally #100=1, #101=null)
