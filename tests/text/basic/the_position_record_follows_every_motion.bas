print xpos; ypos; zpos; moved
move(3,4,5)
print xpos; ypos; zpos; moved; dist(3,4); dist(0,0); dist(0,0,5)
power(1);speed(1);line(3,4,1)
print zpos; moved; dist(3,4)
circle(3,4,2,10)
print xpos; ypos; zpos; moved
arc(3,4,10,0,180)
print xpos; ypos; moved
home
print xpos; ypos; zpos; moved
' (finally prints 0 0 0 0)
' (finally prints 3 4 5 7.071067812 0 5 5)
' (finally prints 1 4 0)
' (finally prints 13 4 2 62.83185307)
' (finally prints -7 4 31.41592654)
' (finally prints 0 0 0 8.306623863)
