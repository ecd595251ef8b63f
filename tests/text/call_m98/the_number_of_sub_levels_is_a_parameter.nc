(run with: --param sub_levels=4)
O1 (NEST-1: four levels as on older controls)
#100=#100+1
M98 P1 (expect alarm PS0077)
M30
(finally #100=5)
