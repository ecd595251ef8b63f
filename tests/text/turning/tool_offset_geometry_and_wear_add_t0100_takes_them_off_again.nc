(run with: --machine lathe2 --set #2701=1 --set #2001=-0.25 --set #2801=2 --set #2101=0.1)
O1 (tool offset: geometry and wear add, T0100 takes them off again)
G97S500M03
G00X60.Z10.
T0101
G00X50.Z0
#100=#5021
#101=#5022
T0100
G00X51.Z1.
#102=#5021
#103=#5022
M30
(finally #100=50.75, #101=2.1, #102=51, #103=1)
