(run with: --machine lathe2)
O1 (#4002 is the speed, #4005 the feed, #4016 the plane)
G97S500M03
G98
#100=#4002
#101=#4005
#102=#4016
M30
(finally #100=97, #101=98, #102=18)
