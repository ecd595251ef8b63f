O1 (LEX-5: running off a subprogram is no return)
M98 P2
#101=1
M30
O2
#100=1
(finally alarm PS5010)
(finally #100=1, #101=null)
