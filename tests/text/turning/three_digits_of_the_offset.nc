(run with: --machine lathe2 --param T_digits=3 --set #2713=2)
O1 (T13013 is tool 13 with offset 13)
T13013
G00X50.Z0
#100=#5021
M30
(finally #100=52)
(finally records: tool 13)
