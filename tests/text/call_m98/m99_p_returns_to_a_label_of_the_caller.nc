O1 (M99-2: the blocks up to N50 are left out)
M98 P2
#100=1
N50 #101=2
M30
O2
M99 P50
(finally #100=null, #101=2)
