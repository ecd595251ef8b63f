(run with: --machine lathe2 --param gsystem=B)
O1 (Words)
G00X50.Z5.
G92X#5021Z#5022 (expect moves: none)
#100=#5041
M30
(finally #100=50)
