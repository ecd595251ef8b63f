O1 (M99-3: to the label of the main program)
M99 P50
#100=1
N50 #101=1
M30
(finally #100=null, #101=1)
