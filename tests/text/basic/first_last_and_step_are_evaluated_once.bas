a=1;b=3;s=1
for i=a to b step s
a=9;b=9;s=9
next
print i
' (finally prints 4)
