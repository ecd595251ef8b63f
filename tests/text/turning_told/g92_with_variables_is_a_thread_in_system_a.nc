(run with: --machine lathe2)
O1 (Words)
G97S500M03
G00X50.Z5.
G92X#5021Z#5022 (expect alarm PS0011)
M30
