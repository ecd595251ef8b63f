O1 (LEX-17: what is left of the right side is *4)
#100=(2+3)*4 (expect alarm PS0114)
M30
(finally #100=null)
