O1 (section 11.5: like M30)
#100=1
M02
#100=2
(finally #100=1)
