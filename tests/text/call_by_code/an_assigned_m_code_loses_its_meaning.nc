(run with: --param 6071=6)
O1 (CODE-2: M06 only calls O9001, which changes no tool)
T3
M06
T4
M30
O9001
#100=1
M99
(finally #100=1)
