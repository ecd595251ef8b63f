for i=0 to 3
a=i%2; b=int(i/2)
if a then if b then print 3; else print 1; else print 0;
next
print
' (finally printed 0 1 0 3 |)
